#include "tests/support/thread_ranks.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace graincrack::test {
namespace {

/// Ends a rank that waits for one that has failed.
struct AnotherHasFailed {};

/// Which rank runs. The others wait for their turn.
class Turns {
public:
    explicit Turns(int n) : ranks_(static_cast<std::size_t>(n)) {}

    /// Waits for the first turn of a rank.
    void begin(int rank) {
        std::unique_lock lock(mutex_);
        await(rank, lock);
    }
    /// Lets others run until `holds`. \throws AnotherHasFailed if that may never be
    void wait(int rank, const std::function<bool()>& holds) {
        std::unique_lock lock(mutex_);
        if (holds()) return;
        place_of(rank).holds = &holds;
        hand_over_after(rank);
        await(rank, lock);
        place_of(rank).holds = nullptr;
        if (!holds()) throw AnotherHasFailed{};
    }
    /// \param error of the rank, or none
    void end(int rank, const std::exception_ptr& error) {
        const std::unique_lock lock(mutex_);
        place_of(rank).error = error;
        place_of(rank).has_ended = true;
        has_failed_ = has_failed_ || error;
        hand_over_after(rank);
    }
    /// After all have ended: throws the error of the lowest rank that has one.
    void rethrow() const {
        for (const Place& place : ranks_) {
            if (place.error) std::rethrow_exception(place.error);
        }
        if (has_failed_) throw std::logic_error("all ranks that have not ended wait for each other");
    }

private:
    struct Place {
        std::condition_variable turn;
        const std::function<bool()>* holds = nullptr;  ///< what the rank waits for
        bool has_ended = false;
        std::exception_ptr error;
    };
    Place& place_of(int rank) { return ranks_[static_cast<std::size_t>(rank)]; }
    void await(int rank, std::unique_lock<std::mutex>& lock) {
        place_of(rank).turn.wait(lock, [&] { return running_ == rank; });
    }
    /// Gives the turn to the next rank that can run, if there is one.
    void hand_over_after(int rank) {
        if (give_turn_after(rank)) return;
        has_failed_ =
            has_failed_ || std::any_of(ranks_.begin(), ranks_.end(), [](const Place& place) { return !place.has_ended; });
        give_turn_after(rank);
    }
    bool give_turn_after(int rank) {
        const int n = static_cast<int>(ranks_.size());
        for (int k = 1; k <= n; ++k) {
            const int next = (rank + k) % n;
            const Place& place = place_of(next);
            if (place.has_ended || !(has_failed_ || place.holds == nullptr || (*place.holds)())) continue;
            running_ = next;
            place_of(next).turn.notify_one();
            return true;
        }
        return false;
    }

    std::mutex mutex_;
    std::deque<Place> ranks_;
    int running_ = 0;
    bool has_failed_ = false;
};

/// A collective call: what each rank has given to each.
struct Call {
    std::string name;
    std::vector<std::vector<Bytes>> given;  ///< by rank
    int n_arrived = 0, n_left = 0;
};

/// What ranks share.
struct World {
    explicit World(int n_ranks) : n(n_ranks), turns(n_ranks) {}
    int n;
    Turns turns;
    std::map<std::int64_t, Call> calls;
    std::map<std::pair<int, int>, std::deque<std::vector<double>>> sent;  ///< from and to: not received yet, in their order
};

class ThreadChannel : public Channel {
public:
    ThreadChannel(World& world, int rank, const std::vector<ChannelEnd>& ends, MessageCounts& counts)
        : world_(world), rank_(rank), ends_(ends), counts_(counts) {
        for (const ChannelEnd& end : ends) {
            sent_.emplace_back(end.sends);
            received_.emplace_back(end.receives);
        }
    }
    std::span<double> to_send(std::size_t end) override { return sent_[end]; }
    [[nodiscard]] std::span<const double> received(std::size_t end) const override { return received_[end]; }
    void start() override {
        if (std::exchange(is_started_, true)) throw std::logic_error("a channel starts again before it has finished");
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            if (ends_[i].sends == 0) continue;
            world_.sent[{rank_, ends_[i].rank}].push_back(sent_[i]);
            ++counts_.messages;
            counts_.bytes += static_cast<std::int64_t>(sizeof(double) * ends_[i].sends);
        }
    }
    void finish() override {
        if (!std::exchange(is_started_, false)) throw std::logic_error("a channel finishes that has not started");
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            if (ends_[i].receives == 0) continue;
            auto& messages = world_.sent[{ends_[i].rank, rank_}];
            world_.turns.wait(rank_, [&] { return !messages.empty(); });
            if (messages.front().size() != ends_[i].receives) {
                throw std::logic_error("a rank sends " + std::to_string(messages.front().size()) +
                                       " numbers to one that expects " + std::to_string(ends_[i].receives));
            }
            received_[i] = std::move(messages.front());
            messages.pop_front();
        }
    }

private:
    World& world_;
    int rank_;
    std::vector<ChannelEnd> ends_;
    MessageCounts& counts_;
    std::vector<std::vector<double>> sent_, received_;
    bool is_started_ = false;
};

class ThreadMessages : public Messages {
public:
    ThreadMessages(World& world, int rank) : world_(world), rank_(rank) {}
    [[nodiscard]] int size() const override { return world_.n; }
    [[nodiscard]] int rank() const override { return rank_; }

    std::vector<Bytes> gather_all(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) override {
        return gathered("gather_all", own, sizes);
    }
    std::vector<Bytes> gather_first(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) override {
        std::vector<Bytes> all = gathered("gather_first", own, sizes);
        return rank_ == 0 ? std::move(all) : std::vector<Bytes>{};
    }
    std::vector<Bytes> exchange(const std::vector<Bytes>& to) override {
        if (to.size() != static_cast<std::size_t>(world_.n)) throw std::logic_error("an exchange needs a message for each rank");
        std::vector<Bytes> from;
        call("exchange", to, [&](const std::vector<Bytes>& given) { from.push_back(given[static_cast<std::size_t>(rank_)]); });
        return from;
    }
    std::unique_ptr<Channel> open(const std::vector<ChannelEnd>& ends) override {
        return std::make_unique<ThreadChannel>(world_, rank_, ends, counts_);
    }
    [[nodiscard]] const MessageCounts& counts() const override { return counts_; }
    void end(int /*exit_code*/) override {}

private:
    /// \param take (what a rank has given), by rank
    template <class Take>
    void call(const std::string& name, std::vector<Bytes> given, const Take& take) {
        const std::int64_t number = n_calls_++;
        Call& call = world_.calls[number];
        if (call.given.empty()) {
            call.name = name;
            call.given.resize(static_cast<std::size_t>(world_.n));
        } else if (call.name != name) {
            throw std::logic_error("a rank calls " + name + " where another one calls " + call.name);
        }
        ++counts_.messages;
        for (const Bytes& bytes : given) counts_.bytes += static_cast<std::int64_t>(bytes.size());
        call.given[static_cast<std::size_t>(rank_)] = std::move(given);
        ++call.n_arrived;
        world_.turns.wait(rank_, [&] { return call.n_arrived == world_.n; });
        for (const std::vector<Bytes>& of_rank : call.given) take(of_rank);
        if (++call.n_left == world_.n) world_.calls.erase(number);
    }
    std::vector<Bytes> gathered(const std::string& name, std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) {
        std::vector<Bytes> all;
        call(name, {Bytes(own.begin(), own.end())}, [&](const std::vector<Bytes>& given) { all.push_back(given.front()); });
        const auto has_size = [](const Bytes& bytes, std::int64_t size) {
            return static_cast<std::int64_t>(bytes.size()) == size;
        };
        if (!std::equal(all.begin(), all.end(), sizes.begin(), sizes.end(), has_size)) {
            throw std::logic_error("a rank gives other numbers of bytes than the others know of");
        }
        return all;
    }

    World& world_;
    int rank_;
    std::int64_t n_calls_ = 0;
    MessageCounts counts_;
};

/// \return what the rank has thrown, unless another one has failed before
std::exception_ptr error_of(World& world, int rank, const std::function<void(const Ranks&)>& body) {
    try {
        world.turns.begin(rank);
        body(Ranks(std::make_unique<ThreadMessages>(world, rank)));
    } catch (const AnotherHasFailed&) {
        return nullptr;
    } catch (...) {
        return std::current_exception();
    }
    return nullptr;
}

}  // namespace

void on_thread_ranks(int n, const std::function<void(const Ranks&)>& body) {
    World world(n);
    std::vector<std::thread> ranks;
    for (int rank = 0; rank < n; ++rank) {
        ranks.emplace_back([&world, &body, rank] { world.turns.end(rank, error_of(world, rank, body)); });
    }
    for (std::thread& rank : ranks) rank.join();
    world.turns.rethrow();
    for (const auto& [ends, messages] : world.sent) {
        if (!messages.empty()) {
            throw std::logic_error("rank " + std::to_string(ends.second) + " has not received a message of rank " +
                                   std::to_string(ends.first));
        }
    }
}

}  // namespace graincrack::test
