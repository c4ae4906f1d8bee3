// The ranks of a run and their exchange of values. A run with one rank pays nothing for it.
#pragma once

#include <algorithm>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "share/base/error.hpp"
#include "solver/ranks/messages.hpp"

namespace graincrack {

/// Conversion of values to bytes and back.
template <class Value>
requires std::is_trivially_copyable_v<Value> Bytes bytes_of_values(const std::vector<Value>& values) {
    const auto raw = std::as_bytes(std::span(values));
    return {raw.begin(), raw.end()};
}
template <class Value>
requires std::is_trivially_copyable_v<Value> std::vector<Value> values_of(const Bytes& bytes) {
    std::vector<Value> values(bytes.size() / sizeof(Value));
    if (!values.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(Value));
    return values;
}
template <class Value>
std::vector<std::vector<Value>> values_of_all(const std::vector<Bytes>& bytes) {
    std::vector<std::vector<Value>> values;
    for (const Bytes& of_rank : bytes) values.push_back(values_of<Value>(of_rank));
    return values;
}

class Ranks {
public:
    Ranks() = default;
    explicit Ranks(std::unique_ptr<Messages> messages) : messages_(std::move(messages)) {}
    /// The single rank of a serial run.
    static const Ranks& alone() {
        static const Ranks one;
        return one;
    }
    [[nodiscard]] int size() const { return messages_ ? messages_->size() : 1; }
    [[nodiscard]] int rank() const { return messages_ ? messages_->rank() : 0; }
    [[nodiscard]] bool is_first() const { return rank() == 0; }
    [[nodiscard]] bool is_alone() const { return size() == 1; }

    /// Returns the values of each rank, by rank.
    template <class Value>
    [[nodiscard]] std::vector<std::vector<Value>> gather_all(const std::vector<Value>& own) const {
        return gather_all(own, sizes_of_all(own.size()));
    }
    /// Does the same if all ranks know the number of values of each rank.
    template <class Value, class Count = std::int32_t>
    [[nodiscard]] std::vector<std::vector<Value>> gather_all(const std::vector<Value>& own,
                                                             const std::vector<Count>& counts) const {
        if (is_alone()) return {own};
        return values_of_all<Value>(messages_->gather_all(std::as_bytes(std::span(own)), bytes_of<Value>(counts)));
    }
    /// Returns the values of all ranks, concatenated.
    template <class Value>
    [[nodiscard]] std::vector<Value> concatenate(const std::vector<Value>& own) const {
        std::vector<Value> all;
        for (const std::vector<Value>& of_rank : gather_all(own)) all.insert(all.end(), of_rank.begin(), of_rank.end());
        return all;
    }
    /// Returns the values of each rank on the first rank, and nothing on the others.
    template <class Value>
    [[nodiscard]] std::vector<std::vector<Value>> gather_first(const std::vector<Value>& own) const {
        if (is_alone()) return {own};
        const auto sizes = bytes_of<Value>(sizes_of_all(own.size()));
        return values_of_all<Value>(messages_->gather_first(std::as_bytes(std::span(own)), sizes));
    }
    /// Sends values to each rank. \param to by rank \return the values that each rank has sent to this one, by rank
    template <class Value>
    [[nodiscard]] std::vector<std::vector<Value>> exchange(const std::vector<std::vector<Value>>& to) const {
        if (is_alone()) return to;
        std::vector<Bytes> bytes;
        for (const std::vector<Value>& of_rank : to) bytes.push_back(bytes_of_values(of_rank));
        return values_of_all<Value>(messages_->exchange(bytes));
    }
    /// Returns the value of the first rank.
    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    [[nodiscard]] Value of_first(Value value) const {
        std::vector<std::int64_t> counts(static_cast<std::size_t>(size()), 0);
        counts.front() = 1;
        struct Boxed {
            Value value;
        };
        return gather_all(std::vector<Boxed>(is_first() ? 1 : 0, {value}), counts).front().front().value;
    }
    /// Calls `act` on the first rank. If it fails, all ranks throw; only the first rank has the message.
    template <class Act>
    void on_first(const Act& act) const {
        std::exception_ptr error;
        int code = 0;
        if (is_first()) {
            try {
                act();
            } catch (const Error& known) {
                error = std::current_exception();
                code = static_cast<int>(known.code());
            } catch (...) {
                error = std::current_exception();
                code = static_cast<int>(ExitCode::internal);
            }
        }
        if (error && is_alone()) std::rethrow_exception(error);
        code = of_first(code);
        if (error) std::rethrow_exception(error);
        if (code != 0) throw Error(static_cast<ExitCode>(code), "the first rank has failed");
    }
    [[nodiscard]] double largest(double value) const {
        take_largest(std::span(&value, 1));
        return value;
    }
    /// Replaces each value by its maximum, or sum, over the ranks.
    void take_largest(std::span<double> values) const {
        combine(values, [](double l, double r) { return std::max(l, r); });
    }
    void take_sums(std::span<std::int64_t> values) const { combine(values, std::plus<>()); }
    /// True if `holds` is true on any rank.
    [[nodiscard]] bool any(bool holds) const { return largest(holds ? 1 : 0) > 0; }
    /// Opens a channel; null for a single rank.
    [[nodiscard]] std::unique_ptr<Channel> open(const std::vector<ChannelEnd>& ends) const {
        return is_alone() ? nullptr : messages_->open(ends);
    }
    [[nodiscard]] MessageCounts counts() const { return messages_ ? messages_->counts() : MessageCounts{}; }
    /// Waits for the other ranks for some seconds at the end of the program, and ends those that do not arrive.
    void end(int exit_code) const {
        if (messages_) messages_->end(exit_code);
    }

private:
    template <class Value, class Count>
    static std::vector<std::int64_t> bytes_of(const std::vector<Count>& counts) {
        std::vector<std::int64_t> sizes(counts.begin(), counts.end());
        for (std::int64_t& size : sizes) size *= static_cast<std::int64_t>(sizeof(Value));
        return sizes;
    }
    /// Number of values of each rank.
    [[nodiscard]] std::vector<std::int64_t> sizes_of_all(std::size_t own) const {
        const std::vector<std::int64_t> of_one{static_cast<std::int64_t>(own)};
        std::vector<std::int64_t> sizes;
        for (const auto& of_rank : gather_all(of_one, std::vector<std::int64_t>(static_cast<std::size_t>(size()), 1))) {
            sizes.push_back(of_rank.front());
        }
        return sizes;
    }
    template <class Value, class Fold>
    void combine(std::span<Value> values, const Fold& fold) const {
        if (is_alone()) return;
        const std::vector<std::size_t> counts(static_cast<std::size_t>(size()), values.size());
        const std::vector<std::vector<Value>> all = gather_all(std::vector<Value>(values.begin(), values.end()), counts);
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = all.front()[i];
            for (std::size_t rank = 1; rank < all.size(); ++rank) values[i] = fold(values[i], all[rank][i]);
        }
    }

    std::unique_ptr<Messages> messages_;
};

}  // namespace graincrack
