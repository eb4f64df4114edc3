/// \file
/// The version of the program, as files that it writes and `--version` tell it. CMake reads it from here, and
/// tst_version says which other places have to move with it.
#pragma once

#define RAMURE_VERSION "0.2.0"
