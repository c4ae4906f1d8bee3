// A run: written by the solver, read by the postprocessor. The file repeats the specimen and adds /run, /history, /cracks and
// /frames.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "share/base/quantities.hpp"
#include "share/file/fabric.hpp"
#include "share/file/sensitivity.hpp"
#include "share/file/specimen.hpp"
#include "share/rock/contact_state.hpp"
#include "share/rock/fracture_process_zone.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// Fraction of the load that the damping forces may carry before a run warns.
inline constexpr double trusted_damping_load = 0.01;

/// Attributes of /run. An attribute has the name of its member. SI units.
struct RunHeader {
    std::string test;                             ///< "uniaxial" | "triaxial" | "brazilian" | "tension"
    std::string material;                         ///< name of the material
    std::string contact_law;                      ///< a name of solver/law/table.hpp
    CrackEvent crack_event = CrackEvent::failed;  ///< by which tables and pictures count the micro-cracks of this law
    std::string coupling;                         ///< "full" | "none"
    std::string fracture_energy_choice;           ///< "mixed" | "mode-i" | "value"; "none" for a law without fracture energy
    PlaneCondition plane = PlaneCondition::strain;
    Rock rock;
    ContactParameters contact;
    Fabric fabric;                       ///< of phases and classes; empty: all are of the rock and the contact
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
    std::string mass_scaling = "none";  ///< "none" | "selective"
    double mass_scaling_factor = 0;     ///< β: added mass over mass, for relative motion across contacts
    double added_mass = 0;              ///< with mass scaling: mass added to the stiffest elements over the mass of the specimen
    double stable_time_step = 0;        ///< s
    double time_step = 0;               ///< s
    // set when the run ends
    std::string stop_reason;  ///< "peak drop" | "strain limit" | "end of the program" | "checkpoint"
    std::int64_t steps = 0;
    std::int64_t integrations = 0;    ///< steps
    double isotropic_end_time = 0;    ///< end of the isotropic stage (triaxial), s; 0 without one
    double peak_axial_stress = 0;     ///< largest compressive stress (tension: tensile), positive, Pa; brazilian: load/(D t)
    double energy_scale = 0;          ///< largest stored energy (strain + contact) of the run, J: the scale of the energy balance
    double energy_balance_error = 0;  ///< energy balance: max over time of |external − sum of the others| / energy_scale
    double platen_force_difference = 0;  ///< max before the peak of |top − bottom| / mean while the mean exceeds half the peak
    double confinement_mean = 0;         ///< achieved after the isotropic stage, Pa
    double confinement_deviation = 0;
    double damping_share = 0;  ///< energy absorbed by damping / external work at the end
    double damping_load = 0;  ///< part of the load that damping forces carry, mean from 0.9 of the strain at the peak to the peak
};

/// Columns of /history, in the order of `history_datasets`.
enum class HistoryColumn : std::size_t {
    time,
    step,
    axial_strain,
    lateral_strain,
    gauge_axial_strain,
    gauge_lateral_strain,
    axial_stress,
    force_top,
    force_bottom,
    confining_pressure,
    energy_external,
    energy_kinetic,
    energy_strain,
    energy_contact,
    energy_fracture_tension,
    energy_fracture_shear,
    energy_friction,
    energy_damping,
    energy_platen,
    non_conservative_work,
    energy_balance_error,
    unbalanced_ratio,
    tensile_cracks,
    shear_cracks,
    platen_speed,
    damping_load,
    energy_numerical,
    count
};
struct HistoryDataset {
    std::string_view name;
    Dimension dimension;
    std::string_view description;
};
extern const std::array<HistoryDataset, static_cast<std::size_t>(HistoryColumn::count)> history_datasets;

/// The history: equally long columns. Tension and elongation positive. Crack columns count contacts (points ÷ 2).
struct History {
    std::array<std::vector<double>, static_cast<std::size_t>(HistoryColumn::count)> columns;
    [[nodiscard]] const std::vector<double>& operator[](HistoryColumn c) const { return columns[static_cast<std::size_t>(c)]; }
    [[nodiscard]] std::vector<double>& operator[](HistoryColumn c) { return columns[static_cast<std::size_t>(c)]; }
    [[nodiscard]] std::size_t size() const { return columns[0].size(); }
};

/// Reads /history of a run, finished or not. \throws InputError
History read_history(const H5Input& file);

/// When something happened to a contact point, and its relative displacement at the end of that step; NaN if it did not.
struct CrackMoment {
    double time = std::numeric_limits<double>::quiet_NaN();     ///< s
    double opening = std::numeric_limits<double>::quiet_NaN();  ///< m
    double sliding = std::numeric_limits<double>::quiet_NaN();  ///< m
    friend bool operator==(const CrackMoment&, const CrackMoment&) = default;
};

/// One row of the crack log: a contact point that passed its peak strength. Quantities are those of that step unless they say
/// more.
struct Crack {
    double time = 0;  ///< s
    std::int64_t step = 0;
    std::int32_t contact = 0;  ///< row of /contacts
    std::uint8_t point = 0;    ///< 0 at a1, 1 at a2
    CrackMode mode = CrackMode::tensile;
    double mode_angle = 0;             ///< atan2(|τ|, σn) of the step before, short of the peak, rad
    std::array<double, 2> position{};  ///< m
    double orientation = 0;            ///< of the tangent from x, counter-clockwise, rad, in [0, π)
    double length = 0;                 ///< half of the edge's length, m
    double opening = 0;                ///< m
    double sliding = 0;                ///< m
    double energy_released = 0;        ///< J: fracture energy dissipated by this point until the end of the run
    CrackMoment damaged_10 = {};       ///< 10 % of its cohesion was lost
    CrackMoment damaged_50 = {};       ///< 50 % was lost
    CrackMoment broken = {};           ///< 90 % was lost
    CrackMoment separated = {};        ///< all tensile strength was lost
};

/// State of the assemblage at one time; lengths as in Specimen.
struct Frame {
    double time = 0;
    std::int64_t step = 0;
    std::vector<std::array<double, 2>> displacement;    ///< [n] m
    std::vector<std::array<double, 2>> velocity;        ///< [n] m/s
    std::vector<std::array<double, 4>> element_stress;  ///< [e] xx yy xy zz, Pa
    std::vector<std::array<double, 2>> opening;         ///< [c] points 0, 1, m
    std::vector<std::array<double, 2>> sliding;         ///< [c] m
    std::vector<std::array<double, 4>> traction;        ///< [c] (normal, shear) of point 0, of point 1; dataset [c,2,2], Pa
    std::vector<std::array<double, 2>> damage;          ///< [c] 0 to 1
    std::vector<std::array<std::uint8_t, 2>> state;     ///< [c] PointState
};

/// What becomes of a frame while a run goes on.
enum class FrameRole : std::uint8_t {
    regular,      ///< one of those at even distances, every second of which goes when there are too many
    kept,         ///< stays: that of a peak, or the last
    peak_so_far,  ///< in a checkpoint: stays, unless a higher peak comes
    present       ///< in a checkpoint: the state of the checkpoint itself, which is no frame of the run
};

/// Writes a run while it is computed. Frames are thinned during the run, so that at the end between `frames` and 2 × `frames`
/// evenly spaced ones are left, plus those marked to keep (peak, last).
class RunWriter {
public:
    /// \param file an output of kind "run", to which the specimen and the header are written at once
    RunWriter(H5Output file, const Specimen& specimen, const RunHeader& header);
    ~RunWriter();

    /// Appends rows [already written, history.size()) of the history and flushes.
    void append_history(const History& history);
    void add_frame(const Frame& frame, FrameRole role);
    /// Adds the frames that another run has so far, with their roles.
    void add_frames(const RunWriter& other);
    /// Removes every second regular frame.
    void thin_frames();
    /// Roles of the frames in time order.
    [[nodiscard]] std::vector<FrameRole> frame_roles() const;
    [[nodiscard]] std::size_t n_frames() const;
    /// The open file, for further groups of a run.
    [[nodiscard]] H5Output& file();
    /// Writes the final header, the crack log and the sensitivity if there is one, numbers the frames in time order, links the
    /// last frame into /VTKHDF, writes /provenance and commits the file.
    void finish(const RunHeader& header, const std::vector<Crack>& cracks, const struct Provenance& provenance,
                const std::vector<SensitivityRow>& sensitivity = {});

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Reads a run; arrays are read on request.
class RunReader {
public:
    /// \param path a run file or "-" \throws InputError
    explicit RunReader(const std::string& path);
    ~RunReader();
    RunReader(RunReader&&) noexcept;

    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] const RunHeader& header() const;
    [[nodiscard]] Specimen specimen() const;
    [[nodiscard]] History history() const;
    [[nodiscard]] std::vector<Crack> cracks() const;
    [[nodiscard]] std::size_t n_frames() const;
    /// Time of each frame, ascending, s.
    [[nodiscard]] std::vector<double> frame_times() const;
    [[nodiscard]] Frame frame(std::size_t index) const;
    [[nodiscard]] double wall_time() const;  ///< from /provenance, s
    [[nodiscard]] int threads() const;
    [[nodiscard]] const H5Input& file() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace graincrack
