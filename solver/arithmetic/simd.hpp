// Kernels are compiled for several vector units from one source; --vector selects one when a run starts. All of them compute the
// same bytes: no fused multiply-add is formed (-ffp-contract=off) and no sum is reordered. A vectorised sum is therefore made by
// lanes: each lane sums every eighth value on all units.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

/// Marks functions that a kernel calls: only inlined code is compiled for the kernel's vector unit.
#define GRAINCRACK_INLINE [[gnu::always_inline]] inline
/// Marks a lambda as a kernel; it stands between its parameters and its body.
#define GRAINCRACK_KERNEL __attribute__((always_inline))

namespace graincrack {

/// Vector units for which kernels are compiled (--vector).
enum class VectorTarget : std::uint8_t { plain, avx2, avx512 };
inline constexpr std::array<std::string_view, 3> vector_target_names{"plain", "avx2", "avx512"};
constexpr std::string_view name_of(VectorTarget target) { return vector_target_names[static_cast<std::size_t>(target)]; }

/// True if this machine supports the vector unit.
inline bool is_available(VectorTarget target) {
#if defined(__x86_64__)
    switch (target) {
        case VectorTarget::avx512: return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
        case VectorTarget::avx2: return __builtin_cpu_supports("avx2") != 0;
        case VectorTarget::plain: break;
    }
#endif
    return target == VectorTarget::plain;
}
/// The widest vector unit of this machine.
inline VectorTarget widest_vector_target() {
    for (const VectorTarget target : {VectorTarget::avx512, VectorTarget::avx2}) {
        if (is_available(target)) return target;
    }
    return VectorTarget::plain;
}

#if defined(__x86_64__)
template <class Kernel>
__attribute__((target("avx512f,avx512dq"))) void run_on_avx512(const Kernel& kernel) {
    kernel();
}
template <class Kernel>
__attribute__((target("avx2"))) void run_on_avx2(const Kernel& kernel) {
    kernel();
}
#endif

/// Runs a kernel on a vector unit that is available. \param kernel a lambda `[&]() GRAINCRACK_KERNEL { … }`
template <class Kernel>
void run_on(VectorTarget target, const Kernel& kernel) {
#if defined(__x86_64__)
    switch (target) {
        case VectorTarget::avx512: run_on_avx512(kernel); return;
        case VectorTarget::avx2: run_on_avx2(kernel); return;
        case VectorTarget::plain: break;
    }
#endif
    kernel();
}

/// Number of lanes of a sum: that of the widest vector unit. Any fixed number gives the same bytes on all units.
inline constexpr std::int32_t sum_lanes = 8;

/// Number of terms of a sum by lanes, rounded up to whole lanes.
constexpr std::int32_t in_whole_lanes(std::int32_t count) { return (count + sum_lanes - 1) / sum_lanes * sum_lanes; }

/// Returns Σ term(k) for k from 0 to `in_whole_lanes(count)` − 1, summed in each lane and then over the lanes. Terms from `count`
/// on must be 0. \param term a lambda `[&](std::int32_t k) GRAINCRACK_KERNEL { … }`
template <class Term>
GRAINCRACK_INLINE double sum_by_lanes(std::int32_t count, const Term& term) {
    double sum[sum_lanes] = {};
    for (std::int32_t k = 0; k < count; k += sum_lanes) {
        for (std::int32_t l = 0; l < sum_lanes; ++l) sum[l] += term(k + l);
    }
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}
/// Returns the sum by lanes of `count` values. The array must have room up to whole lanes; the values there become 0.
GRAINCRACK_INLINE double sum_values_by_lanes(std::int32_t count, double* values) {
    for (std::int32_t k = count; k < in_whole_lanes(count); ++k) values[k] = 0;
    return sum_by_lanes(count, [&](std::int32_t k) GRAINCRACK_KERNEL { return values[k]; });
}

}  // namespace graincrack
