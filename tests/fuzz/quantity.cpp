// Numbers with units: the first byte chooses the quantity, the rest is what a user wrote.
#include <array>

#include "share/base/quantities.hpp"
#include "share/base/units.hpp"
#include "share/rock/contact_parameters.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    static const std::array<Quantity, 8> quantities{quantity::grain_size,
                                                    quantity::young_modulus,
                                                    quantity::internal_friction_angle,
                                                    quantity::mode_i_toughness,
                                                    quantity::density,
                                                    contact_parameter(&ContactParameters::fracture_energy).quantity,
                                                    quantity::damping,
                                                    contact_parameter(&ContactParameters::normal_stiffness).quantity};
    if (size == 0) return 0;
    const Quantity& quantity = quantities[bytes[0] % quantities.size()];
    return fuzz::one_input([&] {
        const double value = parse_quantity(fuzz::text_of(bytes + 1, size - 1), quantity, "--option");
        // What was read is admissible, and reads back from what would be printed.
        if (!quantity.admits(value) || parse_quantity(format_number(value), quantity, "--option") != value) std::abort();
    });
}
