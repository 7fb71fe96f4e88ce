// SPDX-License-Identifier: BSD-3-Clause
#ifndef Random_h
#define Random_h

#include <random>
#include <vector>

namespace fuzz
{
/// Numbers that depend on the seed alone, on every machine.
class Random
{
public:
  explicit Random(unsigned seed)
    : Engine(seed)
  {
  }

  /// 0 ... end - 1; 0 where there is no such number.
  long long below(long long end)
  {
    return end > 0 ? static_cast<long long>(this->Engine() % static_cast<unsigned long long>(end))
                   : 0;
  }

  bool isTime(int one) { return this->below(one) == 0; }

  template <typename Item>
  const Item& oneOf(const std::vector<Item>& items)
  {
    return items[static_cast<std::size_t>(this->below(static_cast<long long>(items.size())))];
  }

private:
  std::mt19937 Engine;
};
}

#endif
