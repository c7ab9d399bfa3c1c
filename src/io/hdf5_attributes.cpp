#include "io/hdf5_attributes.hpp"

#include <algorithm>
#include <cstring>

namespace clack::hdf5 {

namespace {

Id text_type(std::size_t length) {
    Id type(checked(H5Tcopy(H5T_C_S1), "make a text type"), H5Tclose);
    checked_status(H5Tset_size(type.get(), std::max<std::size_t>(length, 1)), "size a text type");
    checked_status(H5Tset_cset(type.get(), H5T_CSET_UTF8), "set a text type");
    checked_status(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "set a text type");
    return type;
}

Id simple_space(std::vector<hsize_t> const& dimensions) {
    auto const space = dimensions.empty() ? H5Screate(H5S_SCALAR)
                                          : H5Screate_simple(static_cast<int>(dimensions.size()),
                                                             dimensions.data(), nullptr);
    return {checked(space, "make a dataspace"), H5Sclose};
}

Id create_attribute(Id const& object, std::string const& name, hid_t type, Id const& space) {
    return {
        checked(H5Acreate2(object.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                "create attribute " + name),
        H5Aclose};
}

Id open_attribute(Id const& object, std::string const& name) {
    return {checked(H5Aopen(object.get(), name.c_str(), H5P_DEFAULT), "open attribute " + name),
            H5Aclose};
}

std::size_t attribute_size(Id const& attribute) {
    Id const space(checked(H5Aget_space(attribute.get()), "read an attribute"), H5Sclose);
    return static_cast<std::size_t>(
        std::max<hssize_t>(H5Sget_simple_extent_npoints(space.get()), 0));
}

/// Splits equal-length, padded texts.
std::vector<std::string> split_texts(std::vector<char> const& bytes, std::size_t length) {
    std::vector<std::string> texts;
    for (std::size_t at = 0; at + length <= bytes.size() && length > 0; at += length) {
        texts.emplace_back(bytes.data() + at, strnlen(bytes.data() + at, length));
    }
    return texts;
}

/// Texts of variable length, as other programs write them.
std::vector<std::string> read_variable_texts(Id const& attribute, Id const& type,
                                             std::size_t count) {
    std::vector<char*> pointers(count, nullptr);
    checked_status(H5Aread(attribute.get(), type.get(), pointers.data()), "read an attribute");
    std::vector<std::string> texts;
    for (auto* const pointer : pointers) {
        texts.emplace_back(pointer ? pointer : "");
        H5free_memory(pointer);
    }
    return texts;
}

} // namespace

void write_attribute(Id const& object, std::string const& name, std::string const& value) {
    auto const type = text_type(value.size());
    auto const attribute = create_attribute(object, name, type.get(), simple_space({}));
    std::string const padded = value.empty() ? std::string(1, '\0') : value;
    checked_status(H5Awrite(attribute.get(), type.get(), padded.data()), "write attribute " + name);
}

void write_attribute(Id const& object, std::string const& name,
                     std::vector<std::string> const& values) {
    std::size_t length = 1;
    for (auto const& value : values) length = std::max(length, value.size());
    std::vector<char> bytes(length * values.size(), '\0');
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::copy(values[i].begin(), values[i].end(), bytes.data() + i * length);
    }
    auto const type = text_type(length);
    auto const attribute =
        create_attribute(object, name, type.get(), simple_space({values.size()}));
    checked_status(H5Awrite(attribute.get(), type.get(), bytes.data()), "write attribute " + name);
}

void write_attribute(Id const& object, std::string const& name, std::vector<int> const& values) {
    auto const space = values.size() == 1 ? simple_space({}) : simple_space({values.size()});
    auto const attribute = create_attribute(object, name, H5T_NATIVE_INT, space);
    checked_status(H5Awrite(attribute.get(), H5T_NATIVE_INT, values.data()),
                   "write attribute " + name);
}

void write_attribute(Id const& object, std::string const& name, double value) {
    auto const attribute = create_attribute(object, name, H5T_NATIVE_DOUBLE, simple_space({}));
    checked_status(H5Awrite(attribute.get(), H5T_NATIVE_DOUBLE, &value), "write attribute " + name);
}

bool has_attribute(Id const& object, std::string const& name) {
    bool const found = H5Aexists(object.get(), name.c_str()) > 0;
    H5Eclear2(H5E_DEFAULT);
    return found;
}

std::vector<std::string> read_text_attributes(Id const& object, std::string const& name) {
    auto const attribute = open_attribute(object, name);
    Id const type(checked(H5Aget_type(attribute.get()), "read attribute " + name), H5Tclose);
    if (H5Tget_class(type.get()) != H5T_STRING) {
        throw Error("cannot read attribute " + name + ": it is not a text");
    }
    auto const count = attribute_size(attribute);
    if (H5Tis_variable_str(type.get()) > 0) return read_variable_texts(attribute, type, count);
    auto const length = H5Tget_size(type.get());
    std::vector<char> bytes(length * count, '\0');
    checked_status(H5Aread(attribute.get(), type.get(), bytes.data()), "read attribute " + name);
    return split_texts(bytes, length);
}

std::string read_text_attribute(Id const& object, std::string const& name) {
    auto const texts = read_text_attributes(object, name);
    return texts.empty() ? std::string() : texts.front();
}

std::vector<int> read_int_attribute(Id const& object, std::string const& name) {
    auto const attribute = open_attribute(object, name);
    std::vector<int> values(attribute_size(attribute));
    checked_status(H5Aread(attribute.get(), H5T_NATIVE_INT, values.data()),
                   "read attribute " + name);
    return values;
}

double read_double_attribute(Id const& object, std::string const& name) {
    double value = 0;
    checked_status(H5Aread(open_attribute(object, name).get(), H5T_NATIVE_DOUBLE, &value),
                   "read attribute " + name);
    return value;
}

void write_text(Id const& parent, std::string const& name, std::string const& text) {
    auto const type = text_type(text.size());
    Id const dataset(
        checked(H5Dcreate2(parent.get(), name.c_str(), type.get(), simple_space({}).get(),
                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                "create dataset " + name),
        H5Dclose);
    std::string const padded = text.empty() ? std::string(1, '\0') : text;
    checked_status(
        H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()),
        "write dataset " + name);
}

std::string read_text(Id const& parent, std::string const& name) {
    auto const dataset = open_dataset(parent, name);
    Id const type(checked(H5Dget_type(dataset.get()), "read dataset " + name), H5Tclose);
    if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 ||
        !shape(dataset).empty()) {
        throw Error("cannot read dataset " + name + ": it is not one text of fixed length");
    }
    std::vector<char> bytes(H5Tget_size(type.get()), '\0');
    checked_status(H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
                   "read dataset " + name);
    return split_texts(bytes, bytes.size()).front();
}

} // namespace clack::hdf5
