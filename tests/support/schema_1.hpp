// Files of schema 1 in tests/data, written by a version of the programs from before schema 2: the same 20 grains as a specimen,
// in a uniaxial test, and in a program that continued this test (with --save-state). All with Augig granite, --frames 0 and
// --mass-scaling selective --mass-scaling-factor 90. Datasets were packed again, to make the files small; their digest is
// unchanged.
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace graincrack::test {

/// Unpacks tests/data/schema-1-NAME.h5.gz; returns the path of the file.
inline std::string unpack_schema_1(const TemporaryFolder& folder, const std::string& name) {
    const std::string path = folder.file(name + ".h5");
    if (std::system(("gzip -dc " GRAINCRACK_TEST_DATA "/schema-1-" + name + ".h5.gz >" + path).c_str()) != 0) {
        throw std::runtime_error("schema-1-" + name + ".h5.gz cannot be unpacked");
    }
    return path;
}

}  // namespace graincrack::test
