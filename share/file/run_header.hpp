// Settings and summary results of a run: /run, /phases and /classes of a run file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "share/file/fabric.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/settings.hpp"
#include "share/rock/contact_state.hpp"
#include "share/rock/fracture_process_zone.hpp"
#include "share/rock/material.hpp"
#include "share/rock/test_kind.hpp"

namespace graincrack {

/// Fraction of the load carried by damping forces beyond which a run warns; chosen, not fitted.
inline constexpr double trusted_damping_load = 0.01;

/// The law and the properties of grains and contacts of a run.
struct MaterialSettings {
    std::string material;                         ///< name of the material
    std::string contact_law;                      ///< a name of solver/law/table.hpp
    CrackEvent crack_event = CrackEvent::failed;  ///< event that counts micro-cracks of this law in tables and pictures
    std::string fracture_energy_choice;           ///< "mixed" | "mode-i" | "value"; "none" for a law without fracture energy
    PlaneCondition plane = PlaneCondition::strain;
    Rock rock;
    ContactParameters contact;
    Fabric fabric;                         ///< of phases and classes; empty: all are the rock and the contact
    std::vector<std::string> class_names;  ///< names of the classes of `fabric.contacts`
};

/// Loading and numerical settings of a run.
struct LoadingSettings {
    std::string test;                    ///< "uniaxial" | "triaxial" | "brazilian" | "tension" | "bend" | "program"
    double platen_friction = 0;          ///< rad
    double confining_pressure = 0;       ///< target, Pa
    std::string rate = "fixed";          ///< "auto" | "fixed" | "blocks"
    double rate_tolerance = 0;           ///< bound of the measures that control the automatic rate; 0 with a fixed rate
    double rate_share = 1;               ///< factor on the speeds, limits and lower bounds of the automatic rate
    double platen_speed = 0;             ///< of each platen, m/s; with an automatic rate, its mean during axial loading
    double damping = 0;                  ///< damping force as a share of the unbalanced force; 0 for none
    std::string damping_form = "local";  ///< "combined" | "local"
    double peak_drop = 0;
    double max_strain = 0;
    double heat = 0;  ///< temperature rise before a standard test, or largest rise of a program and the runs that it continues,
                      ///< K; 0 and no attributes without one
    std::int64_t cooled = 0;            ///< 1 if the temperature returned before the test, or before the program ended
    double span = 0;                    ///< bend: distance of the lower rollers, m; 0 and no attribute in other tests
    std::string mass_scaling = "none";  ///< "none" | "selective"
    double mass_scaling_factor = 0;     ///< β: added mass over mass, for relative motion across contacts
};

/// The settings of a run, attributes of /run with the names of the members, in SI units.
struct RunSettings : MaterialSettings, LoadingSettings {
    Settings request;  ///< values of the requested options
    [[nodiscard]] const TestDescription& description() const { return test_named(test); }
    [[nodiscard]] Loading loading() const { return description().loading; }
    /// "heated by 300 K and cooled", "at +300 K"; "" for an unheated specimen.
    [[nodiscard]] std::string heat_label() const;
    [[nodiscard]] bool is_unconfined_compression() const {
        return loading() == Loading::compression && !description().is_confined;
    }
};

/// The results of a run, further attributes of /run.
struct RunSummary {
    double added_mass = 0;        ///< with mass scaling: mass added to the stiffest elements over the mass of the specimen
    double stable_time_step = 0;  ///< s
    double time_step = 0;         ///< s
    // set when the run ends
    std::string stop_reason;  ///< "peak drop" | "strain limit" | "mouth opening" | "end of the program" | "checkpoint"
    std::int64_t steps = 0;
    std::int64_t integrations = 0;  ///< steps
    double isotropic_end_time = 0;  ///< end of heating and of the isotropic stage, s; 0 without them
    double peak_axial_stress = 0;   ///< largest compressive stress (tension: tensile), positive, Pa; brazilian: load/(D t); bend:
                                    ///< load over length or diameter
    double peak_time = 0;           ///< time of the strength (`find_strength`) or, without failure, of the largest stress, s
    /// Largest stored energy (strain + contact) of the run, J: the scale of the energy balance. For a heated test both are
    /// counted from the placement of its platens.
    double energy_scale = 0;
    double energy_balance_error = 0;     ///< energy balance: max over time of |external − sum of the others| / energy_scale
    double platen_force_difference = 0;  ///< max before the peak of |top − bottom| / mean while the mean exceeds half the peak
    double confinement_mean = 0;         ///< mean after the isotropic stage, Pa
    double confinement_deviation = 0;
    double damping_share = 0;  ///< energy absorbed by damping / external work at the end
    double damping_load = 0;   ///< fraction of the load carried by damping forces, mean from 0.9 of the peak strain to the peak
};

/// Settings and results, as in a run file.
struct RunHeader : RunSettings, RunSummary {};

/// All values in use of rock, contacts, phases and classes of contacts, "contact_cohesion of quartz-mica"; values by temperature
/// are pairs of K and value.
Settings material_values(const MaterialSettings& material);

void write_header(H5Output& file, const RunHeader& header);
/// Writes the fabric of a header, or that of its one rock and contact.
void write_fabric(H5Output& file, const RunHeader& header, const Specimen& specimen);
/// Reads a header and its fabric. \throws InputError if it is damaged
RunHeader read_header(const H5Input& file);

}  // namespace graincrack
