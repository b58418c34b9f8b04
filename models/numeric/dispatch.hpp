// SPDX-License-Identifier: MIT
// Functions compiled for several processors, of which the running one takes the best.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define CIGSIM_DISPATCH __attribute__((target_clones("avx2", "default")))
#else
#define CIGSIM_DISPATCH
#endif
