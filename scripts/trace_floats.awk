# LLVM's assembler of code that is instrumented for libFuzzer, which tells it nothing of floats. Adds
#
# - to each comparison of two floats or doubles that it is traced as one of their bits. Of one sign these
#   are in the order of the numbers, so that a value profile leads to equal ones, as it does of whole
#   numbers;
# - the constants that floats are compared with, or that are added to them, which mutations then take
#   (src/hunting/libfuzzer.cpp): manifuzz_constants, manifuzz_constant_count.

function note(operand) {
  if (operand !~ /^(0x[0-9A-F]+|-?[0-9.]+e[+-][0-9]+)$/ || operand in place_of) return
  constants = constants (count > 0 ? ", " : "") "double " operand
  place_of[operand] = count++
}

function trace(bits, type, first, second,    name) {
  name = "%traced" ++traced
  print "  " name ".a = bitcast " type " " first " to i" bits
  print "  " name ".b = bitcast " type " " second " to i" bits
  print "  call void @__sanitizer_cov_trace_cmp" bits / 8 "(i" bits " " name ".a, i" bits " " name ".b)"
  is_used[bits] = 1
}

/^declare .*@__sanitizer_cov_trace_cmp4\(/ { is_declared[32] = 1 }
/^declare .*@__sanitizer_cov_trace_cmp8\(/ { is_declared[64] = 1 }

# %x = fcmp [flags] ult float %a, %b
/ = (fcmp|fadd|fsub) / && match($0, / (float|double) [^ ,]+, [^ ,]+/) {
  split(substr($0, RSTART + 1, RLENGTH - 1), words, /,? /)
  note(words[2])
  note(words[3])
  if (/ = fcmp /) trace(words[1] == "float" ? 32 : 64, words[1], words[2], words[3])
}

{ print }

END {
  if (is_used[32] && !is_declared[32]) print "declare void @__sanitizer_cov_trace_cmp4(i32, i32)"
  if (is_used[64] && !is_declared[64]) print "declare void @__sanitizer_cov_trace_cmp8(i64, i64)"
  print "@manifuzz_constants = constant [" count + 0 " x double] [" constants "]"
  print "@manifuzz_constant_count = constant i32 " count + 0
}
