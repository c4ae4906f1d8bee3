#include "share/file/crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <type_traits>

#include "share/file/file_checks.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

namespace {

/// Calls `visit(dataset, member)` for each column, in the order of the file, but for those of `moment_columns`.
template <class Visit>
void visit_columns(const Visit& visit) {
    visit(schema::crack_time, &Crack::time);
    visit(schema::crack_step, &Crack::step);
    visit(schema::crack_contact, &Crack::contact);
    visit(schema::crack_point, &Crack::point);
    visit(schema::crack_mode, &Crack::mode);
    visit(schema::crack_mode_angle, &Crack::mode_angle);
    visit(schema::crack_position, &Crack::position);
    visit(schema::crack_orientation, &Crack::orientation);
    visit(schema::crack_length, &Crack::length);
    visit(schema::crack_opening, &Crack::opening);
    visit(schema::crack_sliding, &Crack::sliding);
    visit(schema::crack_energy, &Crack::energy_released);
}

/// How a member is stored: a number, or several.
template <class T>
struct Stored {
    using Type = T;
    static constexpr std::size_t width = 1;
};
template <>
struct Stored<CrackMode> {
    using Type = std::uint8_t;
    static constexpr std::size_t width = 1;
};
template <>
struct Stored<std::array<double, 2>> {
    using Type = double;
    static constexpr std::size_t width = 2;
};

Extents extents_of(std::size_t rows, std::size_t width) { return width == 1 ? Extents{rows} : Extents{rows, width}; }

/// Columns of /cracks that are NaN where a point has not come so far.
struct MomentColumns {
    CrackMoment Crack::*moment;
    std::array<schema::Dataset, 3> datasets;  ///< of time, opening and sliding
};
constexpr std::array moment_columns{
    MomentColumns{&Crack::damaged_10,
                  {schema::crack_time_damaged_10, schema::crack_opening_damaged_10, schema::crack_sliding_damaged_10}},
    MomentColumns{&Crack::damaged_50,
                  {schema::crack_time_damaged_50, schema::crack_opening_damaged_50, schema::crack_sliding_damaged_50}},
    MomentColumns{&Crack::broken, {schema::crack_time_broken, schema::crack_opening_broken, schema::crack_sliding_broken}},
    MomentColumns{&Crack::separated,
                  {schema::crack_time_separated, schema::crack_opening_separated, schema::crack_sliding_separated}}};

/// Calls `visit(dataset, moment, value)` for each of these columns: it holds `crack.*moment.*value`.
template <class Visit>
void visit_moments(const Visit& visit) {
    constexpr std::array values{&CrackMoment::time, &CrackMoment::opening, &CrackMoment::sliding};
    for (const MomentColumns& columns : moment_columns) {
        for (std::size_t i = 0; i < values.size(); ++i) visit(columns.datasets[i], columns.moment, values[i]);
    }
}

template <class T>
void write_crack_column(H5Output& file, const schema::Dataset& dataset, const std::vector<T>& values, std::size_t width = 1) {
    file.write<T>(dataset.path, std::span<const T>(values), extents_of(values.size() / width, width), dataset.unit,
                  dataset.description);
}

/// Entries from 0 to below a limit.
template <class T>
void require_below(const H5Input& file, const schema::Dataset& dataset, const std::vector<T>& values, std::size_t limit) {
    require_all(file, dataset.path, values, fmt::format("0 to {}", static_cast<double>(limit) - 1).c_str(),
                [limit](T value) { return value >= 0 && static_cast<std::size_t>(value) < limit; });
}

}  // namespace

void write_cracks(H5Output& file, const std::vector<Crack>& cracks) {
    file.create_group(schema::cracks_group);
    visit_columns([&]<class T>(const schema::Dataset& dataset, T Crack::*member) {
        std::vector<typename Stored<T>::Type> values;
        for (const Crack& crack : cracks) {
            if constexpr (Stored<T>::width == 1) {
                values.push_back(static_cast<typename Stored<T>::Type>(crack.*member));
            } else {
                values.insert(values.end(), (crack.*member).begin(), (crack.*member).end());
            }
        }
        write_crack_column(file, dataset, values, Stored<T>::width);
    });
    file.attribute(schema::crack_mode.path, "names", std::vector<std::string>{"tensile", "shear"});
    visit_moments([&](const schema::Dataset& dataset, CrackMoment Crack::*moment, double CrackMoment::*value) {
        std::vector<double> values;
        for (const Crack& crack : cracks) values.push_back(crack.*moment.*value);
        write_crack_column(file, dataset, values);
    });
}

std::vector<Crack> read_cracks(const H5Input& file) {
    const std::size_t n = rows_of(file, schema::crack_time.path);
    const std::size_t n_contacts = rows_of(file, schema::contact_nodes.path);
    std::vector<Crack> cracks(n);
    visit_columns([&]<class T>(const schema::Dataset& dataset, T Crack::*member) {
        using Value = typename Stored<T>::Type;
        constexpr std::size_t width = Stored<T>::width;
        const std::vector<Value> values = file.read<Value>(dataset.path, extents_of(n, width));
        if constexpr (std::is_same_v<Value, double>) {
            require_all(file, dataset.path, values, "a finite number", [](double v) { return std::isfinite(v); });
        } else if constexpr (!std::is_same_v<Value, std::int64_t>) {
            require_below(file, dataset, values, std::is_same_v<Value, std::int32_t> ? n_contacts : 2);
        }
        for (std::size_t i = 0; i < n; ++i) {
            if constexpr (width == 1) {
                cracks[i].*member = static_cast<T>(values[i]);
            } else {
                std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(width * i), width, (cracks[i].*member).begin());
            }
        }
    });
    visit_moments([&](const schema::Dataset& dataset, CrackMoment Crack::*moment, double CrackMoment::*value) {
        const std::vector<double> values = file.read<double>(dataset.path, {n});
        require_all(file, dataset.path, values, "a finite number or NaN", [](double v) { return !std::isinf(v); });
        for (std::size_t i = 0; i < n; ++i) cracks[i].*moment.*value = values[i];
    });
    return cracks;
}

}  // namespace graincrack
