#pragma once
// Texts and small numbers that hang on the objects of an HDF5 file.

#include "io/hdf5.hpp"

#include <string>
#include <vector>

namespace clack::hdf5 {

/// Attributes and texts are strings of fixed length: H5MD asks for it.
void write_attribute(Id const& object, std::string const& name, std::string const& value);
void write_attribute(Id const& object, std::string const& name,
                     std::vector<std::string> const& values);
void write_attribute(Id const& object, std::string const& name, std::vector<int> const& values);
void write_attribute(Id const& object, std::string const& name, double value);
bool has_attribute(Id const& object, std::string const& name);
std::string read_text_attribute(Id const& object, std::string const& name);
std::vector<std::string> read_text_attributes(Id const& object, std::string const& name);
std::vector<int> read_int_attribute(Id const& object, std::string const& name);
double read_double_attribute(Id const& object, std::string const& name);

void write_text(Id const& parent, std::string const& name, std::string const& text);
std::string read_text(Id const& parent, std::string const& name);

} // namespace clack::hdf5
