// Functions compiled once for each vector unit and chosen when the program starts. The arithmetic is the same in all of
// them: no fused multiply-add is formed (-ffp-contract=off) and no sum is reordered, so the bytes are the same too.
#pragma once

#include <string>

// Sanitizers and the start-up code that chooses the version do not go together.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define GRAINCRACK_VECTOR_TARGETS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define GRAINCRACK_VECTOR_TARGETS
#endif

namespace graincrack {

/// The version this machine runs: "avx512", "avx2" or "plain".
inline std::string vector_target() {
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
    if (__builtin_cpu_supports("avx512f")) {
        return "avx512";
    }
    if (__builtin_cpu_supports("avx2")) {
        return "avx2";
    }
#endif
    return "plain";
}

}  // namespace graincrack
