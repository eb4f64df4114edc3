/// \file
/// Large data that is shared and never changed in place, compared by what it holds.
#pragma once

#include <memory>
#include <utility>

namespace ramure {

template <class T> class SharedValue
{
public:
    SharedValue() = default;
    explicit SharedValue(T value)
        : m_held(std::make_shared<const T>(std::move(value)))
    {
    }
    [[nodiscard]] explicit operator bool() const { return m_held != nullptr; }
    const T& operator*() const { return *m_held; }
    const T* operator->() const { return m_held.get(); }
    [[nodiscard]] const std::shared_ptr<const T>& pointer() const { return m_held; }
    bool operator==(const SharedValue& other) const
    {
        return m_held == other.m_held || (m_held && other.m_held && *m_held == *other.m_held);
    }

private:
    std::shared_ptr<const T> m_held;
};

} // namespace ramure
