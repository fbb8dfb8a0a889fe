# Writes OUTPUT: the table of all shader FILES (relative to ROOT) as raw string literals, sorted by name.
# A raw literal holds 16 KiB portably; g++ takes 64 KiB, and our shaders are far smaller.
list(SORT FILES)
set(text "#include \"renderer/shader_source.h\"\n\nnamespace lightbench {\n\n")
string(APPEND text "std::span<const EmbeddedShader> embedded_shaders() {\n  static const EmbeddedShader table[] = {\n")
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} content)
  string(APPEND text "      {\"${file}\", R\"GLSL(${content})GLSL\"},\n")
endforeach()
string(APPEND text "  };\n  return table;\n}\n\n}  // namespace lightbench\n")
file(WRITE ${OUTPUT} "${text}")
