#include "solver/ranks/messages.hpp"

#if GRAINCRACK_MPI

#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <climits>
#include <cstdio>
#include <cstdlib>

#include "share/base/error.hpp"
#include "share/base/events.hpp"

namespace graincrack {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// Lengths of messages are counted in words of eight bytes, so that an `int` covers 16 GB.
constexpr std::size_t word = 8;
int words_of(std::size_t bytes) {
    const std::size_t words = (bytes + word - 1) / word;
    if (words > INT_MAX) throw NumericalError("a message between ranks has more than 16 GB: use more ranks");
    return static_cast<int>(words);
}

/// Diverts the output of all ranks except rank 0 into a file, which is shown only if that rank fails alone.
class KeptOutput {
public:
    explicit KeptOutput(int rank) {
        if (rank == 0) return;
        leave_events();
        file_ = std::tmpfile();
        if (file_ == nullptr || std::freopen("/dev/null", "w", stdout) == nullptr) return;
        terminal_ = ::dup(STDERR_FILENO);
        ::dup2(::fileno(file_), STDERR_FILENO);
    }
    void show() const {
        if (terminal_ < 0) return;
        ::dup2(terminal_, STDERR_FILENO);
        std::rewind(file_);
        std::array<char, 4096> line{};
        while (std::fgets(line.data(), static_cast<int>(line.size()), file_) != nullptr) std::fputs(line.data(), stderr);
    }

private:
    std::FILE* file_ = nullptr;
    int terminal_ = -1;  ///< the original stderr
};

class MpiChannel : public Channel {
public:
    MpiChannel(const std::vector<ChannelEnd>& ends, MPI_Comm communicator, MessageCounts& counts)
        : counts_(counts), sent_(ends.size()), received_(ends.size()) {
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
    // Ranks without neighbours, such as those beyond the number of chunks, have no requests; MPI refuses to start none.
    void start() override {
        if (!requests_.empty()) MPI_Startall(static_cast<int>(requests_.size()), requests_.data());
        counts_.messages += n_sends_;
        counts_.bytes += bytes_;
    }
    void finish() override {
        const Clock::time_point begin = Clock::now();
        MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
        counts_.waited += seconds_since(begin);
    }

private:
    MessageCounts& counts_;
    std::vector<std::vector<double>> sent_, received_;
    std::vector<MPI_Request> requests_;
    std::int64_t n_sends_ = 0, bytes_ = 0;
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
    explicit MpiMessages(MPI_Comm communicator) : communicator_(communicator), rank_(rank_in(communicator)), output_(rank_) {
        MPI_Comm_size(communicator, &size_);
    }
    [[nodiscard]] int size() const override { return size_; }
    [[nodiscard]] int rank() const override { return rank_; }

    std::vector<Bytes> gather_all(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) override {
        const Bytes padded = padded_copy(own);
        Parcels parcels(sizes);
        call(1, padded.size(), [&] {
            MPI_Allgatherv(padded.data(), words_of(own.size()), MPI_DOUBLE, parcels.all.data(), parcels.words.data(),
                           parcels.begin.data(), MPI_DOUBLE, communicator_);
        });
        return parcels.unpacked();
    }
    std::vector<Bytes> gather_first(std::span<const std::byte> own, const std::vector<std::int64_t>& sizes) override {
        const Bytes padded = padded_copy(own);
        Parcels parcels(rank_ == 0 ? sizes : std::vector<std::int64_t>{});
        call(rank_ == 0 ? 0 : 1, padded.size(), [&] {
            MPI_Gatherv(padded.data(), words_of(own.size()), MPI_DOUBLE, parcels.all.data(), parcels.words.data(),
                        parcels.begin.data(), MPI_DOUBLE, 0, communicator_);
        });
        return parcels.unpacked();
    }
    std::vector<Bytes> exchange(const std::vector<Bytes>& to) override {
        std::vector<std::int64_t> sizes(to.size());
        std::transform(to.begin(), to.end(), sizes.begin(), [](const Bytes& b) { return static_cast<std::int64_t>(b.size()); });
        std::vector<std::int64_t> sizes_from(to.size());
        call(size_ - 1, word * to.size(),
             [&] { MPI_Alltoall(sizes.data(), 1, MPI_INT64_T, sizes_from.data(), 1, MPI_INT64_T, communicator_); });
        Parcels out(std::move(sizes));
        for (std::size_t i = 0; i < to.size(); ++i) std::copy(to[i].begin(), to[i].end(), out.of(i));
        Parcels in(std::move(sizes_from));
        call(size_ - 1, out.all.size(), [&] {
            MPI_Alltoallv(out.all.data(), out.words.data(), out.begin.data(), MPI_DOUBLE, in.all.data(), in.words.data(),
                          in.begin.data(), MPI_DOUBLE, communicator_);
        });
        return in.unpacked();
    }
    std::unique_ptr<Channel> open(const std::vector<ChannelEnd>& ends) override {
        return std::make_unique<MpiChannel>(ends, communicator_, counts_);
    }
    [[nodiscard]] const MessageCounts& counts() const override { return counts_; }

    void end(int exit_code) override {
        constexpr double patience = 3;  // s
        MPI_Request request{};
        MPI_Ibarrier(communicator_, &request);
        const Clock::time_point begin = Clock::now();
        int done = 0;
        while (done == 0 && seconds_since(begin) < patience) {
            MPI_Test(&request, &done, MPI_STATUS_IGNORE);
            ::usleep(200);
        }
        if (done == 0) {
            output_.show();
            MPI_Abort(MPI_COMM_WORLD, exit_code);
        }
        MPI_Finalize();
    }

private:
    /// Makes a collective call and counts its messages.
    template <class Act>
    void call(int messages, std::size_t bytes, const Act& act) {
        const Clock::time_point begin = Clock::now();
        act();
        counts_.waited += seconds_since(begin);
        counts_.messages += messages;
        counts_.bytes += static_cast<std::int64_t>(bytes);
    }
    static Bytes padded_copy(std::span<const std::byte> values) {
        Bytes padded(word * static_cast<std::size_t>(words_of(values.size())));
        std::copy(values.begin(), values.end(), padded.begin());
        return padded;
    }
    static int rank_in(MPI_Comm communicator) {
        int rank = 0;
        MPI_Comm_rank(communicator, &rank);
        return rank;
    }

    MPI_Comm communicator_;
    int rank_, size_ = 1;
    KeptOutput output_;
    MessageCounts counts_;
};

/// True if a launcher has started several ranks, according to the variables that launchers set. A program that runs alone inside
/// an allocation does not pay for the start of MPI.
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
