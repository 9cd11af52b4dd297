# PROGRAM, PAGE, FILE: writes a page that the program prints, the one for man compressed as packages have it.
execute_process(COMMAND ${PROGRAM} --help ${PAGE} OUTPUT_FILE ${FILE}.new COMMAND_ERROR_IS_FATAL ANY)
if(PAGE STREQUAL "man")
  execute_process(COMMAND gzip -9 -n -f -S .gz ${FILE}.new COMMAND_ERROR_IS_FATAL ANY)
  file(RENAME ${FILE}.new.gz ${FILE})
else()
  file(RENAME ${FILE}.new ${FILE})
endif()
