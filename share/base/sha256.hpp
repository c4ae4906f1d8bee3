// SHA-256 by OpenSSL.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace graincrack {

/// A hash of what is added, in its order.
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;
    void add(const void* data, std::size_t size);
    /// A text and a zero byte behind it, so that texts that follow one another are told apart.
    void add(const std::string& text);
    /// The hash as 64 digits, once.
    std::string hex();

private:
    evp_md_ctx_st* context_;
};

/// The hash of bytes, as the program sha256sum prints it.
std::string sha256_of(std::string_view bytes);

}  // namespace graincrack
