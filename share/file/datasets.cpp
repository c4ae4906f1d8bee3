#include "share/file/datasets.hpp"

#include "share/file/history.hpp"

namespace graincrack {

std::vector<NamedValue> datasets_of(const std::string& kind) {
    std::vector<NamedValue> all;
    const auto add_to = [&](const std::string& group) {
        return [&all, group](const schema::Dataset& dataset) {
            all.push_back({group + dataset.path, std::string(dataset.unit), std::string(dataset.description)});
        };
    };
    visit_specimen_datasets(add_to(""));
    if (kind == "specimen") return all;
    add_to("")(schema::grain_axis);
    for (const HistoryDataset& column : history_datasets) {
        add_to(schema::history_group + std::string("/"))({column.name.data(), si_unit(column.dimension), column.description});
    }
    visit_crack_datasets(add_to(""));
    visit_frame_datasets(add_to(schema::frames_group + std::string("/NNNN/")));
    return all;
}

}  // namespace graincrack
