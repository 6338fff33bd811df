// A vector that nobody changes any more, so that its copies share the elements.
//
//     SharedVector<int> primes(std::vector{2, 3, 5});
//     SharedVector<int> same = primes;                 // no element is copied
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace slicecast {

template <typename T>
class SharedVector {
public:
    SharedVector() = default;
    SharedVector(std::vector<T>&& elements)
        : elements_(std::make_shared<const std::vector<T>>(std::move(elements))) {}

    std::size_t size() const { return elements_ != nullptr ? elements_->size() : 0; }
    bool empty() const { return size() == 0; }
    const T* data() const { return elements_ != nullptr ? elements_->data() : nullptr; }
    const T& operator[](std::size_t i) const { return (*elements_)[i]; }
    const T& back() const { return elements_->back(); }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size(); }

private:
    std::shared_ptr<const std::vector<T>> elements_;  // null: none
};

}  // namespace slicecast
