# glare_embed(OUT.cpp NAMESPACE NAME FILE...): writes OUT.cpp, which defines in NAMESPACE
#   const EmbeddedFile NAME[]  and  const std::size_t NAME_count
# with the name (no folder) and the text of each FILE, so that the installed library needs no
# data files. OUT.cpp is written anew, at configuration, when a FILE changes.
function(glare_embed out namespace name)
  set(body "// Made by cmake/GlareEmbed.cmake from the files named below.\n")
  string(APPEND body "#include \"glare/base/embedded_file.h\"\n\nnamespace ${namespace} {\n\n")
  string(APPEND body "extern const EmbeddedFile ${name}[];\nextern const std::size_t ${name}_count;\n\n")
  string(APPEND body "const EmbeddedFile ${name}[] = {\n")
  set(count 0)
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    get_filename_component(file_name "${file}" NAME)
    file(READ "${file}" text)
    string(APPEND body "    {\"${file_name}\", R\"__glare__(${text})__glare__\"},\n")
    math(EXPR count "${count} + 1")
  endforeach()
  string(APPEND body "};\nconst std::size_t ${name}_count = ${count};\n\n}  // namespace ${namespace}\n")
  file(CONFIGURE OUTPUT "${out}" CONTENT "${body}" @ONLY)
endfunction()
