//! A world of Box2D whose bodies go where a scene has them: its time is what its own profile says
//! that its contacts took, its solver has nothing to do.

use boxdd_sys::ffi::{
    b2Body_GetContactCapacity, b2Body_GetContactData, b2Body_GetTransform,
    b2Body_SetAngularVelocity, b2Body_SetLinearVelocity, b2BodyId, b2BodyType_b2_dynamicBody,
    b2ContactData, b2CreateBody, b2CreatePolygonShape, b2CreateWorld, b2DefaultBodyDef,
    b2DefaultShapeDef, b2DefaultWorldDef, b2DestroyWorld, b2Vec2, b2World_GetProfile,
    b2World_SetContactRecycleDistance, b2World_Step, b2WorldId,
};
use manifuzz_collider::{Body, Float2, Move, TimedWorld};

use crate::{polygon, vector};

const STEP_SECONDS: f32 = 1.0 / 60.0;
const SUB_STEPS: i32 = 1;

pub struct Box2dWorld {
    id: b2WorldId,
    bodies: Vec<b2BodyId>,
    /// The bodies that have a velocity.
    moving: Vec<u32>,
}

/// The area's: Box2D takes a body's extent from it, by which it recycles.
fn centroid(vertices: &[Float2]) -> b2Vec2 {
    let first = vertices[0];
    let [mut x, mut y, mut doubled_area] = [0.0; 3];
    for pair in vertices[1..].windows(2) {
        let [[a, b], [c, d]] = [pair[0], pair[1]].map(|v| [v.x - first.x, v.y - first.y]);
        let doubled = a * d - b * c;
        x += doubled * (a + c) / 3.0;
        y += doubled * (b + d) / 3.0;
        doubled_area += doubled;
    }
    b2Vec2 { x: first.x + x / doubled_area, y: first.y + y / doubled_area }
}

impl Box2dWorld {
    fn set_velocity(&self, body: u32, linear: b2Vec2, angular: f32) {
        let id = self.bodies[body as usize];
        // SAFETY: the body is one of this world's.
        unsafe {
            b2Body_SetLinearVelocity(id, linear);
            b2Body_SetAngularVelocity(id, angular);
        }
    }

    /// Counts pairs with a point that is no gap: Box2D has contacts for speculative ones too.
    fn contacts_of(&self, body: b2BodyId) -> usize {
        // SAFETY: there is room for as many as it has, and it says how many it filled in.
        let all = unsafe {
            let room = b2Body_GetContactCapacity(body);
            let mut all = Vec::with_capacity(room as usize);
            let count = b2Body_GetContactData(body, all.as_mut_ptr(), room);
            all.set_len(count as usize);
            all
        };
        let touches = |data: &b2ContactData| {
            let manifold = &data.manifold;
            manifold.points[..manifold.pointCount as usize].iter().any(|p| p.separation <= 0.0)
        };
        all.iter().filter(|data| touches(data)).count()
    }

    /// From where the body is now, so that no rounding adds up. b2IntegrateRotation turns by the
    /// arc tangent of what it is told.
    fn send(&self, to: &Move) {
        // SAFETY: the body is one of this world's.
        let at = unsafe { b2Body_GetTransform(self.bodies[to.body as usize]) };
        let linear = b2Vec2 {
            x: (to.position.x - at.p.x) / STEP_SECONDS,
            y: (to.position.y - at.p.y) / STEP_SECONDS,
        };
        let cosine = at.q.c * to.rotation.x + at.q.s * to.rotation.y;
        let sine = at.q.c * to.rotation.y - at.q.s * to.rotation.x;
        self.set_velocity(to.body, linear, sine / cosine / STEP_SECONDS);
    }
}

impl TimedWorld for Box2dWorld {
    /// One worker, which is the default. A body that rests stays awake, as whoever calls says what
    /// moves.
    fn create(name: &str) -> Option<Self> {
        let recycles = match name {
            "box2d3" => false,
            "box2d3 recycling" => true,
            _ => return None,
        };
        // SAFETY: what is created is this one's until it is dropped.
        let id = unsafe {
            let mut definition = b2DefaultWorldDef();
            definition.gravity = b2Vec2 { x: 0.0, y: 0.0 };
            definition.enableSleep = false;
            definition.enableContinuous = false;
            definition.maximumLinearSpeed = 1e9;
            let id = b2CreateWorld(&definition);
            if !recycles {
                b2World_SetContactRecycleDistance(id, 0.0);
            }
            id
        };
        Some(Self { id, bodies: Vec::new(), moving: Vec::new() })
    }

    /// Dynamic: Box2D pairs no two bodies that are not. Without mass: nothing pushes those.
    fn add(&mut self, body: &Body) -> bool {
        if body.vertices().len() < 3 {
            return false;
        }
        // SAFETY: the world is there until it is dropped, and shapes are copied.
        unsafe {
            let mut definition = b2DefaultBodyDef();
            definition.type_ = b2BodyType_b2_dynamicBody;
            definition.position = vector(body.position);
            definition.rotation.c = body.rotation.x;
            definition.rotation.s = body.rotation.y;
            let id = b2CreateBody(self.id, &definition);
            let mut shape = b2DefaultShapeDef();
            shape.density = 0.0;
            let mut filled = polygon(body);
            filled.centroid = centroid(body.vertices());
            b2CreatePolygonShape(id, &shape, &filled);
            self.bodies.push(id);
        }
        true
    }

    /// b2World_Step finds pairs and collides where bodies are before it moves them, and refits the
    /// tree to where they are then.
    fn step(&mut self, moves: &[Move]) -> f64 {
        for body in std::mem::take(&mut self.moving) {
            self.set_velocity(body, b2Vec2 { x: 0.0, y: 0.0 }, 0.0);
        }
        for to in moves {
            self.send(to);
            self.moving.push(to.body);
        }
        // SAFETY: the world is there until it is dropped.
        let profile = unsafe {
            b2World_Step(self.id, STEP_SECONDS, SUB_STEPS);
            b2World_GetProfile(self.id)
        };
        let milliseconds = [profile.pairs, profile.collide, profile.refit].map(f64::from);
        1e6 * milliseconds.iter().sum::<f64>()
    }

    /// After a step in which all rest, which collides them where they are. Each contact is two
    /// bodies'.
    fn contacts(&mut self) -> i64 {
        self.step(&[]);
        let of_bodies: usize = self.bodies.iter().map(|id| self.contacts_of(*id)).sum();
        of_bodies as i64 / 2
    }
}

impl Drop for Box2dWorld {
    fn drop(&mut self) {
        // SAFETY: it is not asked again.
        unsafe { b2DestroyWorld(self.id) }
    }
}
