#include "oracle/box2d/world.hpp"

#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "oracle/box2d/shape.hpp"

namespace manifuzz {
namespace {

b2Body* add(b2World& world, const WorldBody& from) {
  b2BodyDef definition;
  definition.type = from.is_fixed ? b2_staticBody : b2_dynamicBody;
  definition.position = box2d::to_box2d(from.body.pose.position);
  definition.angle = std::atan2(from.body.pose.rotation.y(), from.body.pose.rotation.x());
  b2Body* const body = world.CreateBody(&definition);
  const b2PolygonShape shape = box2d::to_box2d(from.body.polygon);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 1;
  fixture.friction = 0.5F;
  body->CreateFixture(&fixture);
  return body;
}

}  // namespace

std::vector<std::vector<Pose<float>>> box2d_trajectory(std::span<const WorldBody> bodies,
                                                       int steps) {
  b2World world({0, -10});
  std::vector<b2Body*> added;
  for (const WorldBody& body : bodies) added.push_back(add(world, body));
  std::vector<std::vector<Pose<float>>> trajectory;
  for (int i = 0; i < steps; ++i) {
    world.Step(1.0F / 60, 8, 3);
    std::vector<Pose<float>>& poses = trajectory.emplace_back();
    for (const b2Body* const body : added) {
      const b2Transform& at = body->GetTransform();
      poses.push_back({{at.p.x, at.p.y}, {at.q.c, at.q.s}});
    }
  }
  return trajectory;
}

}  // namespace manifuzz
