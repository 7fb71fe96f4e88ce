// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Lists.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

using medial::Index;
using medial::IndexLists;
using medial::Lists;
using medial::listsByKey;
using medial::lowestCommonItem;
using medial::None;

namespace
{
IndexLists listsOf(const std::vector<std::vector<Index>>& all)
{
  IndexLists lists;
  for (const std::vector<Index>& list : all)
  {
    lists.append(list);
  }
  return lists;
}

template <typename Item>
std::vector<Item> copied(typename Lists<Item>::View list)
{
  return { list.begin(), list.end() };
}
}

TEST(Lists, AreKeptOneAfterAnother)
{
  const IndexLists lists = listsOf({ { 3, 1 }, {}, { 4 } });
  ASSERT_EQ(lists.size(), 3);
  EXPECT_EQ(copied<Index>(lists[0]), (std::vector<Index>{ 3, 1 }));
  EXPECT_EQ(lists[1].size(), 0);
  EXPECT_EQ(lists[2][0], 4);
  EXPECT_EQ(IndexLists().size(), 0);
}

TEST(Lists, ByKeyHoldTheItemsInTheirOrder)
{
  const unsigned seed = 3;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::vector<std::pair<Index, std::string>> entries;
  std::map<Index, std::vector<std::string>> expected;
  for (int i = 0; i < 500; ++i)
  {
    const Index key = random() % 7;
    entries.emplace_back(key, std::to_string(random() % 50));
    expected[entries.back().first].push_back(entries.back().second);
  }
  const Lists<std::string> lists = listsByKey<std::string>(9, [&entries](const auto& add) {
    for (const auto& [key, item] : entries)
    {
      add(key, item);
    }
  });
  ASSERT_EQ(lists.size(), 9);
  for (Index key = 0; key < 9; ++key)
  {
    EXPECT_EQ(copied<std::string>(lists[key]), expected[key]) << key;
  }
}

TEST(Lists, ByKeyOfNothingAreEmpty)
{
  EXPECT_EQ(listsByKey(0, [](const auto&) {}).size(), 0);
  const IndexLists lists = listsByKey(2, [](const auto&) {});
  ASSERT_EQ(lists.size(), 2);
  EXPECT_EQ(lists[1].size(), 0);
}

TEST(Lists, AreSortedEachForItself)
{
  IndexLists lists = listsOf({ { 5, 1, 3 }, {}, { 2, 0 } });
  lists.sortEach();
  EXPECT_EQ(lists.items, (std::vector<Index>{ 1, 3, 5, 0, 2 }));
}

TEST(Lists, TellTheLowestCommonItem)
{
  const IndexLists lists =
    listsOf({ { 1, 4, 6, 9 }, { 0, 4, 6 }, { 2, 4, 6, 8 }, { 4, 5, 6 }, { 6, 7 }, {} });
  EXPECT_EQ(lowestCommonItem(lists, { 0, 1, 2, 3 }), 4);
  EXPECT_EQ(lowestCommonItem(lists, { 4, 1, 2, 3 }), 6);
  EXPECT_EQ(lowestCommonItem(lists, { 0, 1, 2, 5 }), None);
  EXPECT_EQ(lowestCommonItem(lists, { 5, 1, 2, 3 }), None);
}

TEST(Lists, SortedUniqueValuesAscendWithoutRepeats)
{
  std::vector<int> values{ 3, 1, 3, 2, 1 };
  medial::sortUnique(values);
  EXPECT_EQ(values, (std::vector<int>{ 1, 2, 3 }));
  std::vector<int> none;
  medial::sortUnique(none);
  EXPECT_TRUE(none.empty());
}
