#include "solver/ranks/messages.hpp"

#if GRAINCRACK_MPI

#include <fcntl.h>
#include <fmt/format.h>
#include <mpi.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// All messages are counted in words of eight bytes, so that an `int` counts 16 GB.
constexpr std::size_t word = 8;
int words_of(std::size_t bytes) {
    const std::size_t words = (bytes + word - 1) / word;
    if (words > INT_MAX) throw NumericalError("a message between ranks has more than 16 GB: use more ranks");
    return static_cast<int>(words);
}

/// What a rank says on stderr: the first one at once; the others nothing, unless they have to speak up. What they would have said
/// is kept for that.
class Voice {
public:
    explicit Voice(int rank) {
        if (rank == 0) return;
        const int nowhere = ::open("/dev/null", O_WRONLY);
        kept_ = std::tmpfile();
        if (nowhere < 0 || kept_ == nullptr) return;
        stderr_ = ::dup(STDERR_FILENO);
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(::fileno(kept_), STDERR_FILENO);
        ::close(nowhere);
    }
    void say(const std::string& text) const { static_cast<void>(::write(stderr_, text.data(), text.size()) < 0); }
    /// Says what it has kept.
    void speak_up() const {
        if (kept_ == nullptr) return;
        std::fflush(stderr);
        std::string text;
        ::lseek(::fileno(kept_), 0, SEEK_SET);
        std::array<char, 4096> piece{};
        for (ssize_t n = 0; (n = ::read(::fileno(kept_), piece.data(), piece.size())) > 0;) text.append(piece.data(), n);
        say(text);
    }

private:
    int stderr_ = STDERR_FILENO;
    std::FILE* kept_ = nullptr;
};

/// Another rank on this machine.
struct Peer {
    int rank;
    pid_t process;
};

/// Whether a process lives: one that has ended and that nobody has asked for yet does not.
bool lives(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    if (!std::getline(status, text)) return false;
    const std::size_t name_end = text.rfind(')');
    const char state = name_end == std::string::npos || name_end + 2 >= text.size() ? '?' : text[name_end + 2];
    return state != 'Z' && state != 'X';
}

/// What the other ranks of this machine are, and whether they still live.
class Peers {
public:
    Peers(MPI_Comm communicator, const Voice& voice) : voice_(voice) {
        int size = 0;
        MPI_Comm_rank(communicator, &rank_);
        MPI_Comm_size(communicator, &size);
        struct Place {
            std::array<char, 56> host;
            std::int64_t process;
        };
        Place own{};
        ::gethostname(own.host.data(), own.host.size() - 1);
        own.process = ::getpid();
        std::vector<Place> all(static_cast<std::size_t>(size));
        MPI_Allgather(&own, sizeof(Place), MPI_BYTE, all.data(), sizeof(Place), MPI_BYTE, communicator);
        for (int rank = 0; rank < size; ++rank) {
            const Place& place = all[static_cast<std::size_t>(rank)];
            if (rank != rank_ && place.host == own.host) peers_.push_back({rank, static_cast<pid_t>(place.process)});
        }
        MPI_Comm here = MPI_COMM_NULL;
        MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
        MPI_Win window = MPI_WIN_NULL;
        int* own_place = nullptr;
        MPI_Win_allocate_shared(sizeof(int), sizeof(int), MPI_INFO_NULL, here, static_cast<void*>(&own_place), &window);
        *own_place = 0;
        MPI_Aint place_size = 0;
        int unit = 0;
        MPI_Win_shared_query(window, 0, &place_size, &unit, static_cast<void*>(&is_said_));
        MPI_Barrier(here);
    }
    /// Other ranks on this machine.
    [[nodiscard]] std::size_t count() const { return peers_.size(); }
    /// Ends this rank if another one of this machine has ended. The first that notices says so.
    void require_life() const {
        const auto dead = std::find_if(peers_.begin(), peers_.end(), [](const Peer& peer) { return !lives(peer.process); });
        if (dead == peers_.end()) return;
        if (std::atomic_ref(*is_said_).exchange(1) == 0) {
            voice_.say(fmt::format(
                "graincrack-solve: rank {} has ended before the others; the run ends here; its last checkpoint, if it has "
                "one, resumes it by --restart\n",
                dead->rank));
        }
        ::sleep(1);  // until the line is out
        std::_Exit(static_cast<int>(ExitCode::internal));
    }

private:
    const Voice& voice_;
    int rank_ = 0;
    std::vector<Peer> peers_;
    int* is_said_ = nullptr;  ///< 1 once a rank of this machine has said that another has ended; they share it
};

/// Waits for requests: busily for a while, then it leaves the processor to others between two looks. Where ranks share processors
/// it does so soon; else not before other work seems to be in the way, as what takes the processor keeps it for milliseconds.
class Waiting {
public:
    Waiting(MPI_Comm communicator, const Voice& voice)
        : peers_(communicator, voice),
          busy_looks_(peers_.count() < std::thread::hardware_concurrency() ? many_looks : few_looks) {
        if (const char* delay = std::getenv("GRAINCRACK_MESSAGE_DELAY"); delay != nullptr) delay_ = 1e-6 * std::atof(delay);
    }
    /// \param begin when the messages were sent
    void wait(std::span<MPI_Request> requests, Clock::time_point begin, MessageCounts& counts) {
        const Clock::time_point now = Clock::now();
        int done = 0;
        for (int looks = 0; done == 0; ++looks) {
            MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
            if (done == 0 && looks > busy_looks_) {
                ::sched_yield();
                if (looks % looks_between_checks == 0) require_life(now);
            }
        }
        while (delay_ > 0 && seconds_since(begin) < delay_) ::sched_yield();
        counts.waited += seconds_since(now);
    }

private:
    static constexpr int few_looks = 50;     // some 10 µs
    static constexpr int many_looks = 5000;  // some 1 ms
    static constexpr int looks_between_checks = 1024;
    static constexpr double patience = 0.1;  // s, before the other ranks of this machine are looked at; launchers leave a second

    void require_life(Clock::time_point begin) {
        const double waited = seconds_since(begin);
        if (waited < patience || waited < next_check_) return;
        peers_.require_life();
        next_check_ = waited + patience;
    }

    Peers peers_;
    int busy_looks_;
    double delay_ = 0;       // s, of every message
    double next_check_ = 0;  // s
};

class MpiChannel : public Channel {
public:
    MpiChannel(const std::vector<ChannelEnd>& ends, MPI_Comm communicator, Waiting& waiting, MessageCounts& counts)
        : waiting_(waiting), counts_(counts), sent_(ends.size()), received_(ends.size()) {
        constexpr int tag = 1;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            sent_[i].resize(ends[i].sends);
            received_[i].resize(ends[i].receives);
            if (ends[i].receives > 0) {
                MPI_Recv_init(received_[i].data(), words_of(word * ends[i].receives), MPI_DOUBLE, ends[i].rank, tag, communicator,
                              &requests_.emplace_back());
            }
            if (ends[i].sends > 0) {
                MPI_Send_init(sent_[i].data(), words_of(word * ends[i].sends), MPI_DOUBLE, ends[i].rank, tag, communicator,
                              &requests_.emplace_back());
                ++n_sends_;
                bytes_ += static_cast<std::int64_t>(word * ends[i].sends);
            }
        }
    }
    ~MpiChannel() override {
        for (MPI_Request& request : requests_) MPI_Request_free(&request);
    }
    MpiChannel(const MpiChannel&) = delete;
    MpiChannel& operator=(const MpiChannel&) = delete;
    std::span<double> to_send(std::size_t end) override { return sent_[end]; }
    [[nodiscard]] std::span<const double> received(std::size_t end) const override { return received_[end]; }
    void start() override {
        begin_ = Clock::now();
        if (!requests_.empty()) MPI_Startall(static_cast<int>(requests_.size()), requests_.data());
        counts_.messages += n_sends_;
        counts_.bytes += bytes_;
    }
    void finish() override {
        if (!requests_.empty()) waiting_.wait(requests_, begin_, counts_);
    }

private:
    Waiting& waiting_;
    MessageCounts& counts_;
    std::vector<std::vector<double>> sent_, received_;
    std::vector<MPI_Request> requests_;
    std::int64_t n_sends_ = 0, bytes_ = 0;
    Clock::time_point begin_;
};

/// The bytes of several ranks in one buffer, in words.
struct Parcels {
    std::vector<int> words, begin;  ///< by rank
    std::vector<std::int64_t> bytes;
    Bytes all;
    explicit Parcels(std::vector<std::int64_t> sizes) : words(sizes.size()), begin(sizes.size()), bytes(std::move(sizes)) {
        std::size_t total = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            begin[i] = words_of(word * total);
            words[i] = words_of(static_cast<std::size_t>(bytes[i]));
            total += static_cast<std::size_t>(words[i]);
        }
        all.resize(word * total);
    }
    [[nodiscard]] std::byte* of(std::size_t rank) { return all.data() + word * static_cast<std::size_t>(begin[rank]); }
    [[nodiscard]] std::vector<Bytes> unpacked() {
        std::vector<Bytes> parts;
        for (std::size_t i = 0; i < bytes.size(); ++i) parts.emplace_back(of(i), of(i) + bytes[i]);
        return parts;
    }
};

class MpiMessages : public Messages {
public:
    explicit MpiMessages(MPI_Comm communicator)
        : communicator_(communicator), rank_(rank_in(communicator)), voice_(rank_), waiting_(communicator, voice_) {
        MPI_Comm_size(communicator, &size_);
        MPI_Comm_dup(communicator, &at_end_);
    }
    [[nodiscard]] int size() const override { return size_; }
    [[nodiscard]] int rank() const override { return rank_; }

    std::vector<Bytes> gather_all(std::span<const std::byte> own) override { return gather_all(own, sizes_of_all(own.size())); }
    std::vector<Bytes> gather_all(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) override {
        Parcels parcels(sizes);
        const Bytes padded = padded_copy(own);
        wait_for([&](MPI_Request* request) {
            MPI_Iallgatherv(padded.data(), words_of(own.size()), MPI_DOUBLE, parcels.all.data(), parcels.words.data(),
                            parcels.begin.data(), MPI_DOUBLE, communicator_, request);
        });
        count(size_ - 1, padded.size());
        return parcels.unpacked();
    }
    std::vector<Bytes> gather_first(std::span<const std::byte> own) override {
        std::vector<std::int64_t> sizes = sizes_of_all(own.size());
        if (rank_ != 0) std::fill(sizes.begin(), sizes.end(), 0);
        Parcels parcels(std::move(sizes));
        const Bytes padded = padded_copy(own);
        wait_for([&](MPI_Request* request) {
            MPI_Igatherv(padded.data(), words_of(own.size()), MPI_DOUBLE, parcels.all.data(), parcels.words.data(),
                         parcels.begin.data(), MPI_DOUBLE, 0, communicator_, request);
        });
        count(rank_ == 0 ? 0 : 1, padded.size());
        return rank_ == 0 ? parcels.unpacked() : std::vector<Bytes>{};
    }
    std::vector<Bytes> exchange(const std::vector<Bytes>& to) override {
        std::vector<std::int64_t> sizes(to.size());
        std::transform(to.begin(), to.end(), sizes.begin(), [](const Bytes& b) { return static_cast<std::int64_t>(b.size()); });
        std::vector<std::int64_t> sizes_from(to.size());
        wait_for([&](MPI_Request* request) {
            MPI_Ialltoall(sizes.data(), 1, MPI_INT64_T, sizes_from.data(), 1, MPI_INT64_T, communicator_, request);
        });
        Parcels out(std::move(sizes));
        for (std::size_t i = 0; i < to.size(); ++i) std::copy(to[i].begin(), to[i].end(), out.of(i));
        Parcels in(std::move(sizes_from));
        wait_for([&](MPI_Request* request) {
            MPI_Ialltoallv(out.all.data(), out.words.data(), out.begin.data(), MPI_DOUBLE, in.all.data(), in.words.data(),
                           in.begin.data(), MPI_DOUBLE, communicator_, request);
        });
        count(2 * (size_ - 1), out.all.size());
        return in.unpacked();
    }
    void broadcast(std::span<std::byte> values) override {
        Bytes padded = padded_copy(values);
        wait_for([&](MPI_Request* request) {
            MPI_Ibcast(padded.data(), words_of(padded.size()), MPI_DOUBLE, 0, communicator_, request);
        });
        std::copy_n(padded.begin(), values.size(), values.begin());
        count(1, padded.size());
    }
    void take_largest(std::span<double> values) override {
        const std::vector<double> own(values.begin(), values.end());
        wait_for([&](MPI_Request* request) {
            MPI_Iallreduce(own.data(), values.data(), static_cast<int>(own.size()), MPI_DOUBLE, MPI_MAX, communicator_, request);
        });
        count(1, values.size_bytes());
    }
    void take_sums(std::span<std::int64_t> values) override {
        const std::vector<std::int64_t> own(values.begin(), values.end());
        wait_for([&](MPI_Request* request) {
            MPI_Iallreduce(own.data(), values.data(), static_cast<int>(own.size()), MPI_INT64_T, MPI_SUM, communicator_, request);
        });
        count(1, values.size_bytes());
    }
    std::unique_ptr<Channel> open(const std::vector<ChannelEnd>& ends) override {
        return std::make_unique<MpiChannel>(ends, communicator_, waiting_, counts_);
    }
    [[nodiscard]] const MessageCounts& counts() const override { return counts_; }

    void end(int exit_code) override {
        constexpr double patience = 3;  // s
        MPI_Request request{};
        MPI_Ibarrier(at_end_, &request);
        const Clock::time_point begin = Clock::now();
        int done = 0;
        while (done == 0 && seconds_since(begin) < patience) {
            MPI_Test(&request, &done, MPI_STATUS_IGNORE);
            ::usleep(200);
        }
        if (done == 0) {
            voice_.speak_up();
            MPI_Abort(MPI_COMM_WORLD, exit_code);
        }
        MPI_Finalize();
    }

private:
    template <class Post>
    void wait_for(const Post& post) {
        MPI_Request request{};
        const Clock::time_point begin = Clock::now();
        post(&request);
        waiting_.wait(std::span(&request, 1), begin, counts_);
    }
    std::vector<std::int64_t> sizes_of_all(std::size_t own) {
        std::vector<std::int64_t> sizes(static_cast<std::size_t>(size_));
        const auto size = static_cast<std::int64_t>(own);
        wait_for([&](MPI_Request* request) {
            MPI_Iallgather(&size, 1, MPI_INT64_T, sizes.data(), 1, MPI_INT64_T, communicator_, request);
        });
        count(1, word);
        return sizes;
    }
    static Bytes padded_copy(std::span<const std::byte> values) {
        Bytes padded(word * static_cast<std::size_t>(words_of(values.size())));
        std::copy(values.begin(), values.end(), padded.begin());
        return padded;
    }
    void count(int messages, std::size_t bytes) {
        counts_.messages += messages;
        counts_.bytes += static_cast<std::int64_t>(bytes);
    }

    static int rank_in(MPI_Comm communicator) {
        int rank = 0;
        MPI_Comm_rank(communicator, &rank);
        return rank;
    }

    MPI_Comm communicator_;
    MPI_Comm at_end_ = MPI_COMM_NULL;
    int rank_, size_ = 1;
    Voice voice_;
    Waiting waiting_;
    MessageCounts counts_;
};

/// Whether a launcher has begun several ranks, by what launchers leave in the environment. A tool that runs alone inside of an
/// allocation is none of them, and does not pay for MPI's start.
bool is_launched() {
    constexpr std::array sizes{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE", "MPI_LOCALNRANKS"};
    if (std::any_of(sizes.begin(), sizes.end(), [](const char* name) {
            const char* value = std::getenv(name);
            return value != nullptr && std::atoi(value) > 1;
        })) {
        return true;
    }
    const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
    return std::getenv("PMIX_RANK") != nullptr && tasks != nullptr && std::atoi(tasks) > 1;
}

}  // namespace

std::unique_ptr<Messages> messages_of_launcher() {
    if (!is_launched()) return nullptr;
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    return std::make_unique<MpiMessages>(MPI_COMM_WORLD);
}

bool is_built_with_mpi() { return true; }

}  // namespace graincrack

#else

namespace graincrack {

std::unique_ptr<Messages> messages_of_launcher() { return nullptr; }
bool is_built_with_mpi() { return false; }

}  // namespace graincrack

#endif
