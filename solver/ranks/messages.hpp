// Messages between the ranks of a run. Ranks are processes, on one machine or many, that work on one specimen. The thread that
// started a rank sends and receives its messages.
//
// All ranks make collective calls in the same order. Their results do not depend on the speed of ranks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace graincrack {

using Bytes = std::vector<std::byte>;

/// The doubles that a channel sends to and receives from one rank, a fixed number of each.
struct ChannelEnd {
    int rank;
    std::size_t sends, receives;  ///< number of doubles
};

/// Messages of a fixed size to and from some ranks, sent repeatedly.
class Channel {
public:
    virtual ~Channel() = default;
    /// Buffers of the doubles sent to, and received from, the rank of an end.
    [[nodiscard]] virtual std::span<double> to_send(std::size_t end) = 0;
    [[nodiscard]] virtual std::span<const double> received(std::size_t end) const = 0;
    /// Starts to send the content of `to_send`.
    virtual void start() = 0;
    /// Waits until everything is sent and received.
    virtual void finish() = 0;
};

/// Messages sent so far, and the time spent waiting for messages.
struct MessageCounts {
    std::int64_t messages = 0, bytes = 0;
    double waited = 0;  ///< s
};

/// The transport layer. It does not interpret the content of messages.
class Messages {
public:
    virtual ~Messages() = default;
    [[nodiscard]] virtual int size() const = 0;
    [[nodiscard]] virtual int rank() const = 0;
    /// Returns the bytes of each rank, by rank. \param sizes number of bytes from each rank
    virtual std::vector<Bytes> gather_all(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) = 0;
    /// Does the same for the first rank only; the others receive nothing.
    virtual std::vector<Bytes> gather_first(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) = 0;
    /// Sends each rank its own bytes. \param to by rank \return the bytes that each rank sent to this one, by rank
    virtual std::vector<Bytes> exchange(const std::vector<Bytes>& to) = 0;
    virtual std::unique_ptr<Channel> open(const std::vector<ChannelEnd>& ends) = 0;
    [[nodiscard]] virtual const MessageCounts& counts() const = 0;
    /// Waits for the other ranks at the end of the program; after some seconds it ends those that have not arrived.
    virtual void end(int exit_code) = 0;
};

/// Messages between the ranks that an MPI launcher has started; null for one rank or without MPI.
std::unique_ptr<Messages> messages_of_launcher();
/// True if the program is built with MPI.
bool is_built_with_mpi();

}  // namespace graincrack
