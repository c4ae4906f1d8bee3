// Messages between the ranks of a run: several processes, on one machine or many, that work on one specimen. Each has a thread of
// its own that sends and receives, the one that began it.
//
// Collective calls are made by all ranks, in the same order. What they give does not depend on which rank is fast.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace graincrack {

using Bytes = std::vector<std::byte>;

/// Numbers that go to and come from another rank, always the same ones and as many.
struct ChannelEnd {
    int rank;
    std::size_t sends, receives;  ///< numbers
};

/// Messages of a fixed size to and from some ranks, sent repeatedly.
class Channel {
public:
    virtual ~Channel() = default;
    /// Numbers that go to, and numbers that have come from, the rank of an end.
    [[nodiscard]] virtual std::span<double> to_send(std::size_t end) = 0;
    [[nodiscard]] virtual std::span<const double> received(std::size_t end) const = 0;
    /// Sends what `to_send` holds.
    virtual void start() = 0;
    /// Waits until all has been sent and received.
    virtual void finish() = 0;
};

/// The messages sent so far and the time waited for them.
struct MessageCounts {
    std::int64_t messages = 0, bytes = 0;
    double waited = 0;  ///< s
};

/// The transport. It knows nothing of what it carries.
class Messages {
public:
    virtual ~Messages() = default;
    [[nodiscard]] virtual int size() const = 0;
    [[nodiscard]] virtual int rank() const = 0;
    /// The bytes that each rank gave, by rank. \param sizes bytes that each gives
    virtual std::vector<Bytes> gather_all(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) = 0;
    /// The same for the first rank only; the others get nothing.
    virtual std::vector<Bytes> gather_first(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) = 0;
    /// To each rank what is its own. \return what each rank sent to this one, by rank
    virtual std::vector<Bytes> exchange(const std::vector<Bytes>& to) = 0;
    virtual std::unique_ptr<Channel> open(const std::vector<ChannelEnd>& ends) = 0;
    [[nodiscard]] virtual const MessageCounts& counts() const = 0;
    /// Waits at the end of the tool for the other ranks; after some seconds it ends those that have not come.
    virtual void end(int exit_code) = 0;
};

/// The messages of the ranks that an MPI launcher has begun; none if it is one rank, or this is built without MPI.
std::unique_ptr<Messages> messages_of_launcher();
/// True if this is built with MPI.
bool is_built_with_mpi();

}  // namespace graincrack
