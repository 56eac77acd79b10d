#pragma once
/// Marks what the shared library shows to programs that use it.

#define NILAS_API __attribute__((visibility("default")))
