// Amplitudes: functions of time that a program prescribes at a boundary during a stage.
#pragma once

#include <cstdint>
#include <vector>

namespace graincrack {

/// A function of the time since a stage began. `from` is what was there when it began; sine, Ricker wavelet and pulse act on top
/// of it and leave it behind, constant, ramp and table replace it, keep
/// keeps it.
struct TimeFunction {
    enum class Kind : std::uint8_t { constant, ramp, table, sine, ricker, pulse, keep, rate };
    Kind kind = Kind::constant;
    double value = 0;                   ///< constant; end of the ramp; amplitude of sine, wavelet and pulse
    double from = 0;                    ///< value before
    double duration = 0;                ///< of ramp and pulse; of a sine, 0 without end; s
    double frequency = 0;               ///< of sine and wavelet, Hz
    double phase = 0;                   ///< of the sine, rad
    double peak_time = 0;               ///< of the wavelet, s
    double rate = 0;                    ///< at which the value is gone to, absolute, 1/s
    std::vector<double> times, values;  ///< of the table, linear between, constant outside

    /// ramp: from + (value − from) x² (3 − 2x), x = t/duration        sine: from + value (sin(2π f t + phase))
    /// Ricker: from + value (1 − 2 a) e^−a, a = (π f (t − peak_time))²   pulse: from + value sin²(π t/duration)
    /// rate: from ± rate t, up to the value
    [[nodiscard]] double operator()(double t) const;
    /// Time from which on it changes no more, s; infinite for a sine without end.
    [[nodiscard]] double end() const;
    /// True if it makes waves: sine, wavelet or pulse.
    [[nodiscard]] bool is_wave() const { return kind == Kind::sine || kind == Kind::ricker || kind == Kind::pulse; }
};

/// The function as it runs where `present` is what is there when it starts; NaN, a free velocity, counts as 0 unless it is kept.
TimeFunction starting_from(TimeFunction function, double present);

/// A function that runs since `start`.
struct Amplitude {
    TimeFunction function;
    double start = 0;          ///< s
    bool of_velocity = false;  ///< requested half a step after a step's time; loads are requested at it
    [[nodiscard]] double at(double time) const { return function(time - start); }
};

}  // namespace graincrack
