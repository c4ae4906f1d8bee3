// Comparison of two files, array by array.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "share/file/h5_file.hpp"

namespace graincrack::test {

/// The same bytes in all arrays of a group.
inline void expect_same_arrays(const H5Input& a, const H5Input& b, const std::string& group) {
    ASSERT_EQ(a.children(group), b.children(group));
    EXPECT_GT(a.children(group).size(), 0U);
    for (const std::string& name : a.children(group)) {
        const std::vector<double> left = a.read<double>(group + "/" + name);
        const std::vector<double> right = b.read<double>(group + "/" + name);
        ASSERT_EQ(left.size(), right.size()) << name;
        EXPECT_EQ(std::memcmp(left.data(), right.data(), left.size() * sizeof(double)), 0) << group << "/" << name;
    }
}

}  // namespace graincrack::test
