/* The example as a library of version 1, whose table ends before wall_time: what stands behind is not read. */
#define tps_get_implementation tps_of_the_example
#include "properties/c_abi/example.c"
#undef tps_get_implementation

const tps_implementation *tps_get_implementation(void);

const tps_implementation *tps_get_implementation(void) {
  static tps_implementation old;
  old = *tps_of_the_example();
  old.version = 1;
  return &old;
}
