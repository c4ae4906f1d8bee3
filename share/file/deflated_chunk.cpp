#include "share/file/deflated_chunk.hpp"

#include <zlib.h>

#include "share/base/error.hpp"

namespace graincrack::h5 {
namespace {

constexpr int deflate_level = 1;  // measured: higher levels cost time and save no space
constexpr int window_bits = 15;   // these two are zlib's defaults
constexpr int memory_level = 8;

std::vector<unsigned char> shuffled(std::span<const unsigned char> bytes, std::size_t item_bytes) {
    const std::size_t items = bytes.size() / item_bytes;
    std::vector<unsigned char> planes(bytes.size());
    for (std::size_t byte = 0; byte < item_bytes; ++byte) {
        for (std::size_t item = 0; item < items; ++item) planes[byte * items + item] = bytes[item * item_bytes + byte];
    }
    return planes;
}

}  // namespace

std::vector<unsigned char> deflated_chunk(std::span<const unsigned char> bytes, std::size_t item_bytes) {
    std::vector<unsigned char> planes = shuffled(bytes, item_bytes);
    z_stream stream{};
    if (deflateInit2(&stream, deflate_level, Z_DEFLATED, window_bits, memory_level, Z_RLE) != Z_OK) {
        throw OutputError("an array could not be deflated; more memory is needed");
    }
    std::vector<unsigned char> deflated(deflateBound(&stream, planes.size()));
    stream.next_in = planes.data();
    stream.avail_in = static_cast<uInt>(planes.size());
    stream.next_out = deflated.data();
    stream.avail_out = static_cast<uInt>(deflated.size());
    deflate(&stream, Z_FINISH);  // all of it, as the room is the bound
    deflated.resize(stream.total_out);
    deflateEnd(&stream);
    return deflated;
}

}  // namespace graincrack::h5
