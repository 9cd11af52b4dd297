import java.io.IOException;
import org.jbox2d.collision.Collision;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.pooling.normal.DefaultWorldPool;

/** jbox2d's Collision: polygons, circles, and edges with either. */
public class Jbox2d {
  // tie_bias: k_relativeTol 0.98 and k_absoluteTol 0.001 of Collision.collidePolygons.
  private static final String DECLARATION = """
      {"name": "jbox2d", "version": "%s", "scalar": "float32", "frame": "world",
       "tie_bias": {"absolute": 0.001, "relative": 0.02, "towards": "a"}, "vertices_max": 8,
       "takes_radius": true, "vertices_min": 1, "takes_round": true,
       "declines": [["capsule", "capsule"], ["rounded", "capsule"], ["rounded", "polygon"],
                    ["rounded", "rounded"]], "points": "clip",
       "normal": "a_to_b"}""";

  private static final String SNIPPET = """
      @language java
      @figures by way of A's frame, so to a few roundings of the largest
      @point world.points $m
      import org.jbox2d.collision.*; import org.jbox2d.collision.shapes.*; import org.jbox2d.common.*;
      public class Snippet {
        public static void main(String[] arguments) {
      @each @*.circle?     CircleShape @* = new CircleShape();
      @each @*.circle?     @*.m_p.set(@*.vertices($xf, $yf)@);
      @each @*.segment?     EdgeShape @* = new EdgeShape();
      @each @*.segment?     @*.set(@*.vertices(new Vec2($xf, $yf))@);
      @each @*.polygon?     PolygonShape @* = new PolygonShape(); @*.m_count = @*.count@; @*.m_radius = @*.radius@f; // set would weld
      @each @*.polygon?     Vec2[] of@^ = {@*.vertices(new Vec2($xf, $yf))@}, out@^ = {@*.normals(new Vec2($xf, $yf))@};
      @each @*.polygon?     for (int i = 0; i < @*.count@; ++i) { @*.m_vertices[i].set(of@^[i]); @*.m_normals[i].set(out@^[i]); } @*.computeCentroidToOut(@*.m_vertices, @*.count@, @*.m_centroid);
      @each @!*.polygon?     @*.setRadius(@*.radius@f);
          Transform atA = new Transform(@a.position(new Vec2($xf, $yf))@, new Rot()), atB = new Transform(@b.position(new Vec2($xf, $yf))@, new Rot());
      @each @*.turned?     @*.rotation(at@^.q.c = $xf; at@^.q.s = $yf;)@
          var collision = new Collision(new org.jbox2d.pooling.normal.DefaultWorldPool(10, 10));
          Manifold manifold = new Manifold(); WorldManifold world = new WorldManifold();
      @a.polygon? @b.segment? @b_first
      @a.circle? @!b.circle? @b_first
      @a.polygon? @b.polygon?     collision.@asked(collidePolygons)@(manifold, a, atA, b, atB);
      @a.circle? @b.circle?     collision.@asked(collideCircles)@(manifold, a, atA, b, atB);
      @a.segment? @b.polygon?     collision.@asked(collideEdgeAndPolygon)@(manifold, a, atA, b, atB);
      @a.segment? @b.circle?     collision.@asked(collideEdgeAndCircle)@(manifold, a, atA, b, atB);
      @a.polygon? @b.circle?     collision.@asked(collidePolygonAndCircle)@(manifold, a, atA, b, atB);
      @a.polygon? @b.segment?     collision.@asked(collideEdgeAndPolygon)@(manifold, b, atB, a, atA);
      @a.circle? @b.segment?     collision.@asked(collideEdgeAndCircle)@(manifold, b, atB, a, atA);
      @a.circle? @b.polygon?     collision.@asked(collidePolygonAndCircle)@(manifold, b, atB, a, atA);
      @a.segment?     world.initialize(manifold, atA, a.m_radius, atB, b.m_radius);
      @a.polygon? @!b.segment?     world.initialize(manifold, atA, a.m_radius, atB, b.m_radius);
      @a.circle? @b.circle?     world.initialize(manifold, atA, a.m_radius, atB, b.m_radius);
      @a.polygon? @b.segment?     world.initialize(manifold, atB, b.m_radius, atA, a.m_radius);
      @a.circle? @!b.circle?     world.initialize(manifold, atB, b.m_radius, atA, a.m_radius);
          System.out.println(manifold.pointCount + " points, normal " + world.normal + java.util.List.of(world.points).subList(0, manifold.pointCount));
        }
      }
      """;

  private static final Collision COLLISION = new Collision(new DefaultWorldPool(10, 10));

  private static Vec2 vectorOf(float[] place) {
    return new Vec2(place[0], place[1]);
  }

  // Filled as it stands: PolygonShape.set would weld and reorder.
  private static PolygonShape polygonOf(Protocol.Body body) {
    PolygonShape polygon = new PolygonShape();
    polygon.m_count = body.count();
    for (int i = 0; i < polygon.m_count; ++i) {
      double[] normal = body.normal(i);
      polygon.m_vertices[i].set(vectorOf(body.vertices()[i]));
      polygon.m_normals[i].set((float) normal[0], (float) normal[1]);
    }
    polygon.computeCentroidToOut(polygon.m_vertices, polygon.m_count, polygon.m_centroid);
    return polygon;
  }

  private static Shape shapeOf(Protocol.Body body) {
    Shape shape;
    if (body.count() == 1) {
      shape = new CircleShape();
      ((CircleShape) shape).m_p.set(vectorOf(body.vertices()[0]));
    } else if (body.count() == 2) {
      EdgeShape edge = new EdgeShape();
      edge.set(vectorOf(body.vertices()[0]), vectorOf(body.vertices()[1]));
      shape = edge;
    } else {
      shape = polygonOf(body);
    }
    shape.setRadius(body.radius()); // of an edge as of any Shape; its constructor says 0.01
    return shape;
  }

  private static Transform poseOf(Protocol.Body body) {
    Transform pose = new Transform();
    pose.p.set(vectorOf(body.position()));
    pose.q.c = body.rotation()[0];
    pose.q.s = body.rotation()[1];
    return pose;
  }

  // In the order in which its functions take them: edges, polygons, circles.
  private static int rank(Protocol.Body body) {
    return body.count() == 1 ? 2 : body.count() == 2 ? 0 : 1;
  }

  private static Manifold manifoldOf(Shape one, Transform atOne, Shape two, Transform atTwo) {
    Manifold manifold = new Manifold();
    if (one instanceof EdgeShape edge && two instanceof PolygonShape polygon) {
      COLLISION.collideEdgeAndPolygon(manifold, edge, atOne, polygon, atTwo);
    } else if (one instanceof EdgeShape edge && two instanceof CircleShape circle) {
      COLLISION.collideEdgeAndCircle(manifold, edge, atOne, circle, atTwo);
    } else if (one instanceof PolygonShape first && two instanceof PolygonShape second) {
      COLLISION.collidePolygons(manifold, first, atOne, second, atTwo);
    } else if (one instanceof PolygonShape polygon && two instanceof CircleShape circle) {
      COLLISION.collidePolygonAndCircle(manifold, polygon, atOne, circle, atTwo);
    } else if (one instanceof CircleShape first && two instanceof CircleShape second) {
      COLLISION.collideCircles(manifold, first, atOne, second, atTwo);
    } else {
      throw new Protocol.Unsupported("has no edge against edge");
    }
    return manifold;
  }

  private static boolean isMitred(Protocol.Body body) {
    return body.count() > 2 && body.round();
  }

  private static Protocol.Answer collide(Protocol.Body a, Protocol.Body b) {
    boolean areRound = a.round() || b.round();
    boolean swapped = rank(a) > rank(b);
    Protocol.Body one = swapped ? b : a;
    Protocol.Body two = swapped ? a : b;
    if (rank(two) == 1 && a.radius() + b.radius() > 0 && (isMitred(a) || isMitred(b))) {
      throw new Protocol.Unsupported("its polygons' corners are mitred");
    }
    Transform atOne = poseOf(one);
    Transform atTwo = poseOf(two);
    Manifold manifold = manifoldOf(shapeOf(one), atOne, shapeOf(two), atTwo);
    Protocol.Answer answer = new Protocol.Answer();
    if (manifold.pointCount == 0) return answer;

    // Its world manifold has midpoints and no separations. On either side of a midpoint, along the
    // normal, are both surfaces; how far, the solver takes from the same clip points and plane.
    WorldManifold world = new WorldManifold();
    world.initialize(manifold, atOne, one.radius(), atTwo, two.radius());
    boolean byTwo = manifold.type == Manifold.ManifoldType.FACE_B;
    Protocol.Body incident = byTwo ? one : two;
    for (int i = 0; i < manifold.pointCount; ++i) {
      Vec2 local = manifold.points[i].localPoint;
      double[] clipped = incident.toWorld(local.x, local.y);
      double separation = separationOf(manifold, i, world.normal, atOne, atTwo) - one.radius() - two.radius();
      if (separation > 0 && areRound) continue; // of edges, there for the solver alone
      // Of round shapes on the surface, a radius from the core.
      double out = (byTwo ? 1 : -1) * (areRound ? incident.radius() : 0);
      answer.add(clipped[0] + out * world.normal.x, clipped[1] + out * world.normal.y,
          Math.max(0, -separation));
    }
    double sign = swapped ? -1 : 1;
    answer.setNormal(sign * world.normal.x, sign * world.normal.y);
    if (!areRound) answer.setReference(byTwo ? "b" : "a");
    return answer;
  }

  // As PositionSolverManifold.initialize has it, radii left out.
  private static float separationOf(
      Manifold manifold, int i, Vec2 normal, Transform atOne, Transform atTwo) {
    boolean byTwo = manifold.type == Manifold.ManifoldType.FACE_B;
    Vec2 plane = Transform.mul(byTwo ? atTwo : atOne, manifold.localPoint);
    Vec2 point = Transform.mul(byTwo ? atOne : atTwo, manifold.points[i].localPoint);
    float along = Vec2.dot(point.sub(plane), normal);
    return byTwo ? -along : along;
  }

  public static void main(String[] arguments) throws IOException {
    Protocol.serve(DECLARATION.formatted(Protocol.versionOf(Collision.class)), SNIPPET, Jbox2d::collide);
  }
}
