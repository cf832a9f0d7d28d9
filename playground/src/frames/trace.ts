import './host.ts';
import '../../../panels/trace/main.ts';
