// Nothing: headers are precompiled for a target, which must have a source.
