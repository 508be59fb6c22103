#include <algorithm>

#include "common/error.hpp"
#include "solver/engine/snapshot.hpp"

namespace recoat {

namespace {

/// One description of a saved snapshot, run once to write and once to read: `archive.reals(name, vector)` and so on.
template <class Archive, class Contacts>
void describe_contacts(Archive& archive, const std::string& list, Contacts& c) {
    archive.size(list + "/pairs", c.pairs);
    archive.indices(list + "/first", c.first);
    archive.indices(list + "/second", c.second);
    archive.sizes(list + "/wall_begin", c.wall_begin);
    archive.reals(list + "/slip_x", c.slip_x);
    archive.reals(list + "/slip_y", c.slip_y);
    archive.reals(list + "/slip_z", c.slip_z);
    archive.reals(list + "/attraction", c.attraction);
    archive.reals(list + "/lost_normal", c.lost_normal);
    archive.reals(list + "/lost_tangential", c.lost_tangential);
    archive.reals(list + "/wall_work", c.wall_work);
}

template <class Archive, class Self>
void describe(Archive& archive, Self& s) {
    archive.integer("step", s.step);
    archive.integers("particles/id", s.particles.id);
    archive.rows("particles/position", s.particles.position);
    archive.rows("particles/velocity", s.particles.velocity);
    archive.rows("particles/spin", s.particles.spin);
    archive.rows("particles/contact_velocity", s.particles.contact_velocity);
    archive.rows("particles/contact_spin", s.particles.contact_spin);
    archive.rows("particles/acceleration", s.particles.acceleration);
    archive.rows("particles/rest", s.rest);
    archive.size("particles/awake", s.awake);
    archive.rows("lists/far_reference", s.far_reference);
    archive.rows("lists/close_reference", s.close_reference);
    archive.reals("lists/lost_rolling", s.lost_rolling);
    describe_contacts(archive, "contacts", s.contacts);
    describe_contacts(archive, "dormant", s.dormant);
    archive.real("totals/lost_normal", s.totals.lost_normal);
    archive.real("totals/lost_tangential", s.totals.lost_tangential);
    archive.real("totals/lost_rolling", s.totals.lost_rolling);
    archive.real("totals/wall_work", s.totals.wall_work);
    archive.real("totals/removed_with_walls", s.totals.removed_with_walls);
    archive.integer("lists/sorted_at", s.sorted_at);
    archive.integer("lists/calm", s.calm);
    archive.real("lists/margin", s.margin);
    archive.integer("lists/listed_at", s.listed_at);
    archive.real("lists/travelled", s.travelled);
    archive.real("lists/last_travel", s.last_travel);
    archive.real("largest_overlap", s.largest_overlap);
}

class Writer {
public:
    EngineState state;

    void reals(const std::string& name, const std::vector<double>& v) { state.reals[name] = v; }
    void integers(const std::string& name, const std::vector<std::int64_t>& v) { state.integers[name] = v; }
    void indices(const std::string& name, const std::vector<std::int32_t>& v) { integers(name, {v.begin(), v.end()}); }
    void sizes(const std::string& name, const std::vector<std::size_t>& v) { integers(name, {v.begin(), v.end()}); }
    void real(const std::string& name, double v) { reals(name, {v}); }
    void integer(const std::string& name, std::int64_t v) { integers(name, {v}); }
    void size(const std::string& name, std::size_t v) { integer(name, static_cast<std::int64_t>(v)); }
    void rows(const std::string& name, const std::vector<Row>& v) {
        std::vector<double> flat;
        flat.reserve(4 * v.size());
        for (const Row& row : v) flat.insert(flat.end(), {row.x, row.y, row.z, row.w});
        reals(name, flat);
    }
};

class Reader {
public:
    explicit Reader(const EngineState& state) : state_(state) {}

    void reals(const std::string& name, std::vector<double>& v) { v = find(state_.reals, name); }
    void integers(const std::string& name, std::vector<std::int64_t>& v) { v = find(state_.integers, name); }
    void indices(const std::string& name, std::vector<std::int32_t>& v) { convert(find(state_.integers, name), v); }
    void sizes(const std::string& name, std::vector<std::size_t>& v) { convert(find(state_.integers, name), v); }
    void real(const std::string& name, double& v) { v = one(find(state_.reals, name), name); }
    void integer(const std::string& name, std::int64_t& v) { v = one(find(state_.integers, name), name); }
    void size(const std::string& name, std::size_t& v) {
        v = static_cast<std::size_t>(one(find(state_.integers, name), name));
    }
    void rows(const std::string& name, std::vector<Row>& v) {
        const std::vector<double>& flat = find(state_.reals, name);
        v.resize(flat.size() / 4);
        for (std::size_t i = 0; i < v.size(); ++i)
            v[i] = {flat[4 * i], flat[4 * i + 1], flat[4 * i + 2], flat[4 * i + 3]};
    }

private:
    template <class T>
    static const std::vector<T>& find(const std::map<std::string, std::vector<T>>& arrays, const std::string& name) {
        const auto found = arrays.find(name);
        if (found == arrays.end())
            throw InputError("checkpoint: the array '" + name +
                             "' is missing; the file is damaged or of another version, start from an earlier one");
        return found->second;
    }
    template <class T>
    static T one(const std::vector<T>& values, const std::string& name) {
        if (values.size() != 1)
            throw InputError("checkpoint: '" + name +
                             "' must hold one value; the file is damaged, start from an earlier one");
        return values.front();
    }
    template <class T>
    static void convert(const std::vector<std::int64_t>& from, std::vector<T>& to) {
        to.resize(from.size());
        std::transform(from.begin(), from.end(), to.begin(), [](std::int64_t v) { return static_cast<T>(v); });
    }

    const EngineState& state_;
};

constexpr std::size_t doubles_per_wall = 15;

void put(std::vector<double>& flat, Vec3 v) { flat.insert(flat.end(), {v.x, v.y, v.z}); }
Vec3 get(const double* flat) { return {flat[0], flat[1], flat[2]}; }

void save_walls(EngineState& state, const std::string& prefix, const std::vector<Wall>& walls) {
    std::vector<double> geometry;
    std::vector<std::int64_t> kinds, names, lengths;
    for (const Wall& wall : walls) {
        for (const Vec3 v : {wall.point, wall.normal, wall.lower, wall.upper, wall.velocity}) put(geometry, v);
        kinds.push_back(2 * static_cast<std::int64_t>(wall.kind) + wall.active);
        lengths.push_back(static_cast<std::int64_t>(wall.name.size()));
        names.insert(names.end(), wall.name.begin(), wall.name.end());
    }
    state.reals[prefix + "/geometry"] = geometry;
    state.integers[prefix + "/kinds"] = kinds;
    state.integers[prefix + "/names"] = names;
    state.integers[prefix + "/name_lengths"] = lengths;
}

std::vector<Wall> load_walls(Reader& reader, const std::string& prefix) {
    std::vector<double> geometry;
    std::vector<std::int64_t> kinds, names, lengths;
    reader.reals(prefix + "/geometry", geometry);
    reader.integers(prefix + "/kinds", kinds);
    reader.integers(prefix + "/names", names);
    reader.integers(prefix + "/name_lengths", lengths);
    std::vector<Wall> walls(kinds.size());
    auto letter = names.begin();
    for (std::size_t w = 0; w < walls.size(); ++w) {
        const double* flat = geometry.data() + w * doubles_per_wall;
        walls[w].kind = static_cast<WallKind>(kinds[w] / 2);
        walls[w].active = kinds[w] % 2 != 0;
        walls[w].point = get(flat);
        walls[w].normal = get(flat + 3);
        walls[w].lower = get(flat + 6);
        walls[w].upper = get(flat + 9);
        walls[w].velocity = get(flat + 12);
        walls[w].name.assign(letter, letter + lengths[w]);
        letter += lengths[w];
    }
    return walls;
}

}  // namespace

EngineState saved(const Snapshot& snapshot) {
    Writer writer;
    describe(writer, snapshot);
    writer.state.integers["walls/since"] = snapshot.walls.since();
    save_walls(writer.state, "walls/now", snapshot.walls.now());
    save_walls(writer.state, "walls/anchor", snapshot.walls.anchor());
    return writer.state;
}

Snapshot loaded(const EngineState& state) {
    Snapshot snapshot;
    snapshot.fresh = false;
    Reader reader(state);
    describe(reader, snapshot);
    std::vector<std::int64_t> since;
    reader.integers("walls/since", since);
    snapshot.walls = MovingWalls(load_walls(reader, "walls/now"), load_walls(reader, "walls/anchor"), since);
    return snapshot;
}

}  // namespace recoat
