// The page as `manifuzz report` writes it, from its sources and any data.

import {readFileSync} from 'node:fs';

const folder = new URL('../../src/report/page/', import.meta.url);

function sources(ending) {
  const files = readFileSync(new URL('files.txt', folder), 'utf8').split('\n');
  return files.filter((file) => file.endsWith(ending)).map((file) => readFileSync(new URL(file, folder), 'utf8')).join('');
}

/** The HTML of a page that shows `data`. */
export function assemble(data) {
  const parts = {
    '@style@': sources('.css'),
    '@script@': sources('.js'),
    '@data@': JSON.stringify(data).replaceAll('<', '\\u003c'),
  };
  return sources('.html').replace(/@style@|@script@|@data@/g, (place) => parts[place]);
}
