// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include <functional>
#include <string>
#include <vector>

/// An option of the command line: what it is called, what --help says of it, and what it does.
struct Option
{
  std::string name;        ///< "--output"
  std::string placeholder; ///< stands for its value in --help, as "DIR"; empty: it takes no value
  std::string help;        ///< one or more lines
  std::function<void(const std::string& value)> take; ///< the value is empty if it takes none
};

/// Reads the command line from left to right. A value follows its option as the next word or after
/// '='. "-h" is short for "--help".
/// @param program    its name, for messages
/// @param takeOther  gets each word that doesn't begin with '-'
/// @throw UsageError  an option is unknown or lacks its value
void parse(int argc, char* argv[], const std::string& program, const std::vector<Option>& options,
  const std::function<void(const std::string& word)>& takeOther);

/// The lines of --help that describe the options, in their order.
std::string helpOf(const std::vector<Option>& options);

/// The pieces of a text between any of `separators`.
std::vector<std::string> split(const std::string& text, const char* separators);

/// Reads a plain decimal number: digits with at most one point. False if it isn't one.
bool parseNumber(const std::string& text, double& number);

/// Reads a whole number from 0 on that fits an int. False if it isn't one.
bool parseCount(const std::string& text, int& number);

#endif
