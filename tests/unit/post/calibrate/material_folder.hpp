// A folder with the material of a calibration, Augig granite with changes.
#pragma once

#include <gtest/gtest.h>

#include <fstream>

#include "post/calibrate/folder.hpp"
#include "share/base/text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::calibrate {

class MaterialFolder : public ::testing::Test {
protected:
    MaterialFolder() { write(granite()); }
    static std::string granite() { return text_of_file(GRAINCRACK_SOURCE "/share/materials/augig-granite.toml"); }
    /// The text of the granite with `added` before the first line that begins with `key`.
    static std::string granite_with(const std::string& added, const std::string& key) {
        std::string text = granite();
        return text.insert(text.find("\n" + key) + 1, added);
    }
    void write(const std::string& text) { std::ofstream(folder_.file("material.toml")) << text; }
    /// The material of the granite with further tables.
    Material granite_and(const std::string& tables) {
        write(granite() + "\n" + tables);
        return material();
    }
    [[nodiscard]] Material material() const { return read_material(folder_.file("material.toml")); }
    Problem problem(const std::vector<std::string>& settings = {}) const { return read_problem(material(), settings); }

    test::TemporaryFolder folder_;
};

}  // namespace graincrack::calibrate
