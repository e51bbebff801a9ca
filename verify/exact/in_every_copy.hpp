// Functions that are compiled for several kinds of processor.
#pragma once

// On x86-64 fma is an instruction of newer processors and a slow function elsewhere: functions so marked are
// compiled for both and chosen when the program starts. The results are the same. Sanitizers cannot
// instrument the choice, and without optimisation nothing is inlined into the copies.
//
// What such a function calls has to be part of its copies: out of line it would be compiled once, for every
// processor, and call the slow function.
#if defined(__x86_64__) && defined(__linux__) && defined(__OPTIMIZE__) && !defined(TPS_SANITIZED)
#define TPS_WITH_FMA __attribute__((target_clones("fma", "default")))
#else
#define TPS_WITH_FMA
#endif
#define TPS_IN_EVERY_COPY [[gnu::always_inline]] inline
