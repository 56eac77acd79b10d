#pragma once
/// The versions of Nilas and of what it was built with.
#include <map>
#include <string>

namespace nilas::output {

/// The versions of the program, its libraries and the compiler, by name.
std::map<std::string, std::string> program_versions();

/// Kind of build and flags of the compiler.
std::string program_build();

}  // namespace nilas::output
