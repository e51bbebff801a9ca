// Random123 refuses processors that its authors have not tried. WebAssembly is 32-bit and little-endian, as
// RISC-V may be. That draws are those of the native program is what the tests of the traces show.
#pragma once

#define __riscv 1
#include_next <Random123/philox.h>
#undef __riscv
