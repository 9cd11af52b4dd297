# manifuzz_texts(name header): the files that texts.txt of this folder lists, as the constants that the header declares;
# each file is watched. Alone in a library that links nothing: a command waits for all that its library links, and
# sources wait for the commands of what theirs links.
function(manifuzz_texts name header)
  set(here ${CMAKE_CURRENT_SOURCE_DIR})
  set(embed ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed.cmake)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/texts.cpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS texts.txt)
  file(STRINGS texts.txt texts)
  list(TRANSFORM texts REPLACE ".* " "${here}/")
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${here} -DHEADER=${header} -DOUTPUT=${source} -P ${embed}
    DEPENDS ${embed} texts.txt ${texts}
    COMMENT "Embedding the texts of ${header}" VERBATIM)
  add_library(manifuzz_${name} STATIC ${source})
  target_link_libraries(manifuzz_${name} PRIVATE manifuzz_options)
endfunction()
