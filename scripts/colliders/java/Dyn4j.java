import java.io.IOException;
import org.dyn4j.collision.manifold.ClippingManifoldSolver;
import org.dyn4j.collision.manifold.Manifold;
import org.dyn4j.collision.manifold.ManifoldPoint;
import org.dyn4j.collision.narrowphase.Gjk;
import org.dyn4j.collision.narrowphase.NarrowphaseDetector;
import org.dyn4j.collision.narrowphase.Penetration;
import org.dyn4j.collision.narrowphase.Sat;
import org.dyn4j.geometry.Capsule;
import org.dyn4j.geometry.Circle;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Polygon;
import org.dyn4j.geometry.Rotation;
import org.dyn4j.geometry.Segment;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;

/** dyn4j's ClippingManifoldSolver after either detector: {@code java Dyn4j sat}, or {@code gjk}. */
public class Dyn4j {
  // second_point: Capsule.EDGE_FEATURE_SELECTION_CRITERIA is 0.98, the cosine of this angle.
  private static final String DECLARATION = """
      {"name": "dyn4j-%s", "version": "6.0.0", "scalar": "float64", "frame": "world", "tie_bias": 0,
       "vertices_max": 8, "takes_radius": false, "vertices_min": 1, "takes_round": false,
       "second_point": 0.2003348423231196, "points": "clip", "normal": "b_to_a"}""";

  private static final String SNIPPET = """
      import org.dyn4j.collision.manifold.*;
      import org.dyn4j.collision.narrowphase.*;
      import org.dyn4j.geometry.*;

      public class Snippet {
        static Convex shapeOf(double[][] vertices, double radius, double unit) {
          Vector2[] at = new Vector2[vertices.length];
          for (int i = 0; i < at.length; ++i) {
            at[i] = new Vector2((float) vertices[i][0], (float) vertices[i][1]).multiply(unit);
          }
          if (at.length > 2) return new Polygon(at);
          if (at.length == 2 && radius == 0) return new Segment(at[0], at[1]);
          Convex shape = new Circle((float) radius);
          Vector2 centre = at[0];
          if (at.length == 2) {
            shape = new Capsule(at[0].distance(at[1]) + 2 * (float) radius, 2 * (float) radius);
            shape.rotate(Rotation.of(at[0].to(at[1])));
            centre = at[0].sum(at[1]).multiply(0.5);
          }
          shape.translate(centre);
          return shape;
        }

        // What the rotation lacks of a unit vector goes into the vertices.
        static double unitOf(double[] rotation) {
          return Math.hypot((float) rotation[0], (float) rotation[1]);
        }

        static Transform poseOf(double[] position, double[] rotation) {
          Transform pose = new Transform();
          pose.setRotation(Rotation.of(new Vector2((float) rotation[0], (float) rotation[1])));
          pose.setTranslation((float) position[0], (float) position[1]);
          return pose;
        }

        public static void main(String[] arguments) {
          double[] turnA = @a.rotation{}@, turnB = @b.rotation{}@;
          Convex a = shapeOf(new double[][] @a.vertices{}@, @a.radius@, unitOf(turnA));
          Convex b = shapeOf(new double[][] @b.vertices{}@, @b.radius@, unitOf(turnB));
          Transform atA = poseOf(new double[] @a.position{}@, turnA);
          Transform atB = poseOf(new double[] @b.position{}@, turnB);
          Penetration penetration = new Penetration();
          Manifold manifold = new Manifold();
          boolean overlap = new %s().detect(a, atA, b, atB, penetration);
          System.out.println(overlap + ", " + penetration);
          if (overlap) new ClippingManifoldSolver().getManifold(penetration, a, atA, b, atB, manifold);
          System.out.println(manifold.getPoints().size() + " points, " + manifold);
        }
      }
      """;

  private static Convex shapeOf(Protocol.Body body) {
    Vector2[] at = new Vector2[body.count()];
    for (int i = 0; i < at.length; ++i) {
      at[i] = new Vector2(body.vertices()[i][0], body.vertices()[i][1]).multiply(body.length());
    }
    double radius = body.radius();
    try {
      if (at.length > 2 && radius > 0) throw new Protocol.Unsupported("its polygons have no radius");
      if (at.length > 2) return new Polygon(at);
      if (at.length == 2 && radius == 0) return new Segment(at[0], at[1]);
      if (at.length == 2) return capsule(at[0], at[1], radius);
    } catch (IllegalArgumentException error) { // its own checks of shapes
      throw new Protocol.Unsupported(error.getMessage());
    }
    Circle circle = new Circle(radius);
    circle.translate(at[0]);
    return circle;
  }

  // dyn4j makes capsules along an axis.
  private static Capsule capsule(Vector2 start, Vector2 end, double radius) {
    Capsule capsule = new Capsule(start.distance(end) + 2 * radius, 2 * radius);
    capsule.rotate(Rotation.of(start.to(end)));
    capsule.translate(start.sum(end).multiply(0.5));
    return capsule;
  }

  private static Transform poseOf(Protocol.Body body) {
    Transform pose = new Transform();
    pose.setRotation(Rotation.of(new Vector2(body.rotation()[0], body.rotation()[1]))); // makes it unit
    pose.setTranslation(body.position()[0], body.position()[1]);
    return pose;
  }

  private static Protocol.Answer collide(NarrowphaseDetector detector, Protocol.Body a, Protocol.Body b) {
    Convex shapeA = shapeOf(a);
    Convex shapeB = shapeOf(b);
    Transform poseA = poseOf(a);
    Transform poseB = poseOf(b);
    Penetration penetration = new Penetration();
    Manifold manifold = new Manifold();
    Protocol.Answer answer = new Protocol.Answer();
    boolean touch = detector.detect(shapeA, poseA, shapeB, poseB, penetration)
        && new ClippingManifoldSolver().getManifold(
            penetration, shapeA, poseA, shapeB, poseB, manifold);
    if (!touch) return answer;
    for (ManifoldPoint point : manifold.getPoints()) {
      answer.add(point.getPoint().x, point.getPoint().y, point.getDepth());
    }
    answer.setNormal(manifold.getNormal().x, manifold.getNormal().y);
    return answer;
  }

  public static void main(String[] arguments) throws IOException {
    boolean isGjk = arguments.length == 1 && arguments[0].equals("gjk");
    if (!isGjk && !(arguments.length == 1 && arguments[0].equals("sat"))) {
      System.err.println("Dyn4j: 'sat' or 'gjk' is expected");
      System.exit(2);
    }
    NarrowphaseDetector detector = isGjk ? new Gjk() : new Sat();
    Protocol.serve(DECLARATION.formatted(isGjk ? "gjk" : "sat"),
        SNIPPET.formatted(isGjk ? "Gjk" : "Sat"), (a, b) -> collide(detector, a, b));
  }
}
