#pragma once
/// The machine that a program runs on, and what it takes of it, for reports.
#include <string>

namespace nilas {

/// Kernel, its release and the architecture: "Linux 6.1.0-28-amd64 x86_64".
std::string system_text();
/// Model name of the processor; empty where the system does not say.
std::string processor_text();
/// Processor time that this process has taken so far, on all of its threads, for itself and in the kernel [s].
double processor_seconds();

}  // namespace nilas
