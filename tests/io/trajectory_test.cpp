#include "io/file_errors.hpp"
#include "io/trajectory_reader.hpp"
#include "tests/io/made_up_run.hpp"

#include <boost/test/unit_test.hpp>

#include <fstream>

using namespace clack;
using namespace clack::test;

namespace {

Folder const folder;

auto fault_is(FileFault fault) {
    return [=](FileError const& error) {
        BOOST_TEST_MESSAGE(error.what());
        return error.fault == fault && std::string(error.what()).find('\n') == std::string::npos;
    };
}

void overwrite_bytes(std::string const& path, std::uint64_t at, std::string const& bytes) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(at));
    file << bytes;
}

} // namespace

BOOST_AUTO_TEST_CASE(what_is_written_is_read_to_the_last_bit) {
    for (auto const boundary : {Boundary::walls, Boundary::periodic}) {
        auto const header = made_up_header(boundary, 5);
        write_made_up_run(folder.file("whole.h5"), header, 7);
        TrajectoryReader const reader(folder.file("whole.h5"));
        BOOST_TEST(!reader.left_open());
        BOOST_TEST(reader.header().scene_text == header.scene_text);
        BOOST_TEST(reader.header().seed == header.seed);
        BOOST_TEST(reader.header().model.queue == "heap");
        BOOST_TEST(reader.header().provenance.flags == own_provenance().flags);
        BOOST_TEST((reader.header().system.boundary == boundary));
        BOOST_REQUIRE_EQUAL(reader.frame_count(), 7u);
        for (std::size_t k = 0; k < 7; ++k) {
            auto const expected = made_up_frame(5, static_cast<std::int64_t>(k));
            auto const frame = reader.snapshot(k);
            BOOST_TEST(frame.time == expected.time);
            BOOST_TEST(frame.ball_collisions == expected.ball_collisions);
            BOOST_TEST((frame.positions.array() == expected.positions.array()).all());
            BOOST_TEST((frame.velocities.array() == expected.velocities.array()).all());
            if (boundary == Boundary::periodic) {
                BOOST_TEST((frame.images.array() == expected.images.array()).all());
            }
            auto const sample = made_up_sample(static_cast<std::int64_t>(k));
            BOOST_TEST(reader.frame_sample(k).tallies.virial == sample.tallies.virial);
            BOOST_TEST(reader.samples(7)[k].tallies.wall_impulse == sample.tallies.wall_impulse);
            BOOST_TEST(reader.samples(7)[k].time == sample.time);
            auto const event = reader.events(k, 1).front();
            auto const made_up = made_up_event(static_cast<std::int64_t>(k));
            BOOST_TEST((event.kind == made_up.kind));
            BOOST_TEST(event.offset == made_up.offset);
            BOOST_TEST(event.second == made_up.second);
            BOOST_TEST((event.velocity_second == made_up.velocity_second));
        }
    }
}

BOOST_AUTO_TEST_CASE(checkpoint_keeps_every_limb) {
    for (int const limbs : {1, 2, 3}) {
        auto const header = made_up_header(Boundary::periodic, 3, Events::stored, limbs);
        write_made_up_run(folder.file("limbs.h5"), header, 4);
        auto const point = TrajectoryReader(folder.file("limbs.h5")).resume_point();
        auto const expected = made_up_point(3, limbs, 3);
        BOOST_TEST((point.phase == expected.phase));
        BOOST_TEST(point.frames == 4u);
        BOOST_TEST(point.events == 4u);
        BOOST_TEST(point.cpu_seconds == expected.cpu_seconds);
        BOOST_TEST(point.engine.records == expected.engine.records);
        BOOST_TEST(point.engine.offset == expected.engine.offset);
        BOOST_TEST((point.engine.images.array() == expected.engine.images.array()).all());
        BOOST_TEST(point.engine.hash == expected.engine.hash);
        BOOST_TEST(point.engine.epoch == expected.engine.epoch);
        BOOST_TEST(point.engine.tallies.virial == expected.engine.tallies.virial);
    }
}

BOOST_AUTO_TEST_CASE(file_can_be_followed_while_it_is_written) {
    // A copy is what another process sees, and what a kill at this moment leaves; HDF5 shares what
    // one process has open twice.
    auto const copy = folder.file("left.h5");
    auto const header = made_up_header(Boundary::walls, 4);
    TrajectoryWriter writer(folder.file("growing.h5"), header);
    BOOST_TEST(!std::filesystem::exists(folder.file("growing.h5"))); // until it is whole
    auto start = made_up_point(4, 1, 0);
    writer.flush(start);
    for (std::int64_t k = 0; k < 5; ++k) {
        add_made_up(writer, 4, 1, k, 1);
        std::filesystem::copy_file(folder.file("growing.h5"), copy,
                                   std::filesystem::copy_options::overwrite_existing);
        TrajectoryReader const reader(copy);
        BOOST_TEST(reader.left_open());
        BOOST_TEST(reader.frame_count() == static_cast<std::size_t>(k + 1));
        BOOST_TEST(reader.resume_point().engine.epoch == k);
        BOOST_TEST((last_frame(copy).positions == made_up_frame(4, k).positions));
    }
    BOOST_CHECK_EXCEPTION(WriterLock(folder.file("growing.h5")), FileError,
                          fault_is(FileFault::in_use));
    std::filesystem::resize_file(copy, std::filesystem::file_size(copy) - 100);
    BOOST_CHECK_EXCEPTION(TrajectoryReader{copy}, FileError, fault_is(FileFault::truncated));
    BOOST_CHECK_EXCEPTION(last_frame(copy), FileError, fault_is(FileFault::truncated));
    writer.close();
    BOOST_CHECK_NO_THROW(WriterLock(folder.file("growing.h5")));
}

BOOST_AUTO_TEST_CASE(start_that_fails_leaves_no_file) {
    {
        TrajectoryWriter const writer(folder.file("failed.h5"), made_up_header(Boundary::walls, 2));
        BOOST_TEST(std::filesystem::exists(folder.file(".failed.h5.partial")));
    }
    BOOST_TEST(!std::filesystem::exists(folder.file("failed.h5")));
    BOOST_TEST(!std::filesystem::exists(folder.file(".failed.h5.partial")));
}

BOOST_AUTO_TEST_CASE(copy_ends_at_the_checkpoint) {
    auto const header = made_up_header(Boundary::periodic, 3);
    write_made_up_run(folder.file("source.h5"), header, 6);
    TrajectoryReader const source(folder.file("source.h5"));
    auto point = made_up_point(3, 1, 2);
    point.frames = 3;
    point.events = 2;
    {
        TrajectoryWriter writer(folder.file("copy.h5"), header);
        writer.copy_from(source, point, source.samples(1));
        writer.flush(point);
        writer.close();
    }
    TrajectoryReader const copy(folder.file("copy.h5"));
    BOOST_TEST(copy.frame_count() == 3u);
    BOOST_TEST(copy.sample_count() == 1u);
    BOOST_TEST(copy.event_count() == 2u);
    BOOST_TEST((copy.snapshot(2).images == made_up_frame(3, 2).images));
    BOOST_TEST(copy.resume_point().frames == 3u);
}

BOOST_AUTO_TEST_CASE(each_fault_of_a_file_has_its_name) {
    auto const name = folder.file("faulty.h5");
    BOOST_CHECK_EXCEPTION(TrajectoryReader(folder.file("none.h5")), FileError,
                          fault_is(FileFault::missing));
    BOOST_CHECK_EXCEPTION(last_frame(folder.file("")), FileError, fault_is(FileFault::missing));
    std::ofstream(name) << "not a trajectory at all";
    BOOST_CHECK_EXCEPTION(TrajectoryReader{name}, FileError, fault_is(FileFault::not_hdf5));
    std::ofstream{name};
    BOOST_CHECK_EXCEPTION(TrajectoryReader{name}, FileError, fault_is(FileFault::not_hdf5));
    { auto const bare = hdf5::create_file(name); }
    BOOST_CHECK_EXCEPTION(TrajectoryReader{name}, FileError, fault_is(FileFault::not_h5md));
    BOOST_CHECK_EXCEPTION(last_frame(name), FileError, fault_is(FileFault::not_h5md));
}

BOOST_AUTO_TEST_CASE(truncated_file_is_told_at_any_length) {
    auto const whole = folder.file("whole_again.h5");
    auto const name = folder.file("truncated.h5");
    write_made_up_run(whole, made_up_header(Boundary::walls, 50), 40);
    auto const length = std::filesystem::file_size(whole);
    for (double const part : {0.001, 0.01, 0.1, 0.3, 0.5, 0.9, 0.999}) {
        std::filesystem::copy_file(whole, name, std::filesystem::copy_options::overwrite_existing);
        std::filesystem::resize_file(
            name, static_cast<std::uintmax_t>(part * static_cast<double>(length)));
        BOOST_CHECK_EXCEPTION(TrajectoryReader(name).resume_point(), FileError,
                              fault_is(FileFault::truncated));
        BOOST_CHECK_EXCEPTION(last_frame(name), FileError, fault_is(FileFault::truncated));
    }
}

BOOST_AUTO_TEST_CASE(truncated_file_of_another_program_is_told) {
    auto const name = folder.file("foreign.h5");
    write_made_up_run(name, made_up_header(Boundary::walls, 50), 40);
    {
        hdf5::Id const file(H5Fopen(name.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
        H5Ldelete(file.get(), "checkpoint", H5P_DEFAULT); // what only clack's own have
    }
    BOOST_TEST(last_frame(name).positions.cols() == 50);
    std::filesystem::resize_file(name, std::filesystem::file_size(name) - 1);
    BOOST_CHECK_EXCEPTION(last_frame(name), FileError, fault_is(FileFault::truncated));
}

BOOST_AUTO_TEST_CASE(damaged_checkpoint_falls_back_on_the_other_and_then_says_so) {
    auto const name = folder.file("damaged.h5");
    auto const header = made_up_header(Boundary::walls, 4);
    write_made_up_run(name, header, 4);
    std::uint64_t addresses[2];
    {
        auto const file = hdf5::open_file(name, hdf5::Sharing::exclusive);
        addresses[0] = H5Dget_offset(hdf5::open_dataset(file, "checkpoint/a/records").get());
        addresses[1] = H5Dget_offset(hdf5::open_dataset(file, "checkpoint/b/records").get());
    }
    auto const newest = TrajectoryReader(name).resume_point().engine.epoch;
    // The first write goes to slot b, and the start of a run writes one: the fifth stands in b.
    overwrite_bytes(name, addresses[1], "x");
    BOOST_TEST(TrajectoryReader(name).resume_point().engine.epoch == newest - 1);
    overwrite_bytes(name, addresses[0] + 9, "x");
    BOOST_CHECK_EXCEPTION(TrajectoryReader(name).resume_point(), FileError,
                          fault_is(FileFault::no_checkpoint));
}

BOOST_AUTO_TEST_CASE(files_of_others_and_of_other_versions_are_told_apart) {
    auto const name = folder.file("other.h5");
    auto const set = [&](std::string const& path, std::string const& attribute, int value) {
        write_made_up_run(name, made_up_header(Boundary::walls, 2), 1);
        hdf5::Id const file(H5Fopen(name.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
        hdf5::Id const object(H5Gopen2(file.get(), path.c_str(), H5P_DEFAULT), H5Gclose);
        hdf5::Id const at(H5Aopen(object.get(), attribute.c_str(), H5P_DEFAULT), H5Aclose);
        if (value > 0) {
            H5Awrite(at.get(), H5T_NATIVE_INT, &value);
        } else {
            hdf5::Id const type(H5Aget_type(at.get()), H5Tclose);
            H5Awrite(at.get(), type.get(), "other");
        }
    };
    set("parameters", "format", 99);
    BOOST_CHECK_EXCEPTION(TrajectoryReader{name}, FileError, fault_is(FileFault::other_version));
    set("h5md/creator", "name", 0);
    BOOST_CHECK_EXCEPTION(TrajectoryReader{name}, FileError, fault_is(FileFault::not_clack));
    BOOST_TEST(last_frame(name).positions.cols() == 2); // a start may come from anybody
}

BOOST_AUTO_TEST_CASE(output_path_is_refused_before_anything_is_written) {
    auto const says = [](std::string const& part) {
        return [=](InputError const& error) {
            BOOST_TEST_MESSAGE(error.what());
            return std::string(error.what()).find(part) != std::string::npos;
        };
    };
    BOOST_CHECK_EXCEPTION(require_writable(folder.file("no/such/place.h5")), InputError,
                          says("there is no folder"));
    BOOST_CHECK_EXCEPTION(require_writable(folder.file("")), InputError, says("is a folder"));
    BOOST_CHECK_EXCEPTION(require_writable("/dev/null"), InputError, says("not an ordinary file"));
    BOOST_CHECK_EXCEPTION(require_writable("/proc/clack.h5"), InputError,
                          says("cannot be written"));
    std::ofstream(folder.file("thesis.tex")) << "years of work";
    BOOST_CHECK_EXCEPTION(require_writable(folder.file("thesis.tex")), InputError,
                          says("is not a trajectory"));
    BOOST_CHECK_NO_THROW(require_writable(folder.file("new.h5")));
    BOOST_TEST(!std::filesystem::exists(folder.file("new.h5")));
    BOOST_TEST(!std::filesystem::exists(folder.file(".new.h5.partial")));
}
