#include "share/base/processors.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace graincrack {
namespace {

/// Processors that the quota of this process's control group amounts to; a large number without a quota.
double control_group_quota() {
    double least = 1e9;
    const auto take = [&](const std::string& quota, double period) {
        if (quota.empty() || quota == "max" || quota.front() == '-' || !(period > 0)) return;
        least = std::min(least, std::strtod(quota.c_str(), nullptr) / period);
    };
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        if (line.compare(0, 3, "0::") != 0) continue;
        for (std::string path = line.substr(3);; path.erase(path.find_last_of('/'))) {
            std::string quota;
            double period = 0;
            if (std::ifstream file("/sys/fs/cgroup" + path + "/cpu.max"); file >> quota >> period) take(quota, period);
            if (path.find('/') == std::string::npos) break;
        }
    }
    std::string quota;
    double period = 0;
    std::ifstream quota_file("/sys/fs/cgroup/cpu/cpu.cfs_quota_us");  // version 1
    std::ifstream period_file("/sys/fs/cgroup/cpu/cpu.cfs_period_us");
    if (quota_file >> quota && period_file >> period) take(quota, period);
    return least;
}

}  // namespace

int available_processors() {
    int processors = 0;
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) processors = CPU_COUNT(&set);
    if (processors < 1) processors = static_cast<int>(std::thread::hardware_concurrency());
    return std::max(1, static_cast<int>(std::min<double>(processors, std::ceil(control_group_quota() - 1e-6))));
}

}  // namespace graincrack
