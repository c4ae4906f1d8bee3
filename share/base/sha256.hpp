// Computes SHA-256 with OpenSSL.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace graincrack {

/// The hash of data that are added in sequence.
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;
    void add(const void* data, std::size_t size);
    /// Adds a text and a zero byte, which separates it from the next text.
    void add(const std::string& text);
    /// Returns the hash as 64 hexadecimal digits; to be called once.
    std::string hex();

private:
    evp_md_ctx_st* context_;
};

/// The hash of bytes, as the program sha256sum prints it.
std::string sha256_of(std::string_view bytes);

}  // namespace graincrack
