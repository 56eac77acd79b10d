#pragma once
/// The machine that a program runs on, for reports.
#include <string>

namespace nilas {

/// Kernel, its release and the architecture: "Linux 6.1.0-28-amd64 x86_64".
std::string system_text();
/// Model name of the processor; empty where the system does not say.
std::string processor_text();

}  // namespace nilas
