# Writes a source with a function that returns the bytes of a file:
# cmake -DFILE=... -DFUNCTION=namespace::name -DOUTPUT=... -P embed.cmake
file(READ ${FILE} bytes HEX)
# A literal of 64 bytes a line; the compiler joins them.
string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
string(REPEAT "...." 64 line)
string(REGEX REPLACE "(${line})" "\\1\"\n    \"" bytes "${bytes}")
file(WRITE ${OUTPUT} "// Made by cmake/embed.cmake.
#include <string_view>

namespace microslip::experiments {

std::string_view ${FUNCTION}();

std::string_view ${FUNCTION}() {
  static constexpr char bytes[] =
    \"${bytes}\";
  return {bytes, sizeof bytes - 1};
}

}  // namespace microslip::experiments
")
