#pragma once
/// The library cpp-httplib. The system headers that it takes define a macro of a name that Eigen uses.
#include <httplib.h>
#undef _res
