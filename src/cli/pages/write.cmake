# PROGRAM, PAGE, FILE: writes a page that the program prints; nothing where it fails.
execute_process(COMMAND ${PROGRAM} --help ${PAGE} OUTPUT_FILE ${FILE}.new COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${FILE}.new ${FILE})
