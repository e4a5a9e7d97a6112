import java.io.File;
import java.util.Arrays;
import org.semanticweb.HermiT.Configuration;
import org.semanticweb.HermiT.Reasoner;
import org.semanticweb.owlapi.apibinding.OWLManager;
import org.semanticweb.owlapi.model.*;
import org.semanticweb.owlapi.reasoner.InferenceType;

/**
 * How long a warm HermiT takes, in one process, to read an ontology and to classify it. Prints milliseconds, medians of the
 * runs after the warm-up: "load classify classes". Run it without compiling:
 *
 *     java -cp HermiT.jar HermitProduct.java product.ofn WARM-UPS RUNS
 */
public class HermitProduct {
    private static double median(double[] times) {
        Arrays.sort(times);
        return times[times.length / 2];
    }

    public static void main(String[] arguments) throws Exception {
        File file = new File(arguments[0]);
        int warm = Integer.parseInt(arguments[1]), runs = Integer.parseInt(arguments[2]);
        double[] load = new double[runs], classify = new double[runs];
        int classes = 0;
        for (int i = -warm; i < runs; ++i) {
            long start = System.nanoTime();
            OWLOntologyManager manager = OWLManager.createOWLOntologyManager();
            OWLOntology ontology = manager.loadOntologyFromOntologyDocument(file);
            long loaded = System.nanoTime();
            Reasoner reasoner = new Reasoner(new Configuration(), ontology);
            reasoner.precomputeInferences(InferenceType.CLASS_HIERARCHY);
            long done = System.nanoTime();
            if (!reasoner.isConsistent()) throw new IllegalStateException("inconsistent");
            classes = ontology.getClassesInSignature().size();
            reasoner.dispose();
            if (i < 0) continue;
            load[i] = (loaded - start) / 1e6;
            classify[i] = (done - loaded) / 1e6;
        }
        System.out.println(median(load) + " " + median(classify) + " " + classes);
    }
}
